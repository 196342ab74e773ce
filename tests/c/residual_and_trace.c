/* The global stick orbit of the dry-friction system from C: reads chi eta V e1 e2 and the
 * six unknowns from the command line, prints the six residuals and the trace.
 *
 *     cc -std=c99 -I generated tests/c/residual_and_trace.c generated/dry_friction.c -lm
 */
#include <stdio.h>
#include <stdlib.h>

#include "dry_friction.h"

int main(int count, char **words)
{
    double parameters[5], unknowns[6];
    double spectrum[7], residual[6], trace;
    if (count != 12) {
        fprintf(stderr, "usage: %s chi eta V e1 e2 z10 z20 ta tau tau1 tau2\n", words[0]);
        return 2;
    }
    for (int i = 0; i < 5; ++i)
        parameters[i] = strtod(words[1 + i], NULL);
    for (int i = 0; i < 6; ++i)
        unknowns[i] = strtod(words[6 + i], NULL);
    dry_friction_spectrum(parameters, spectrum, NULL);
    dry_friction_global_stick_equations(parameters, spectrum, unknowns, NULL, residual, NULL, NULL);
    dry_friction_global_stick_trace(parameters, spectrum, unknowns, NULL, &trace, NULL);
    for (int i = 0; i < 6; ++i)
        printf("%.17g\n", residual[i]);
    printf("%.17g\n", trace);
    return 0;
}
