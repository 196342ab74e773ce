/* Motions from a file, outside Python: run under sanitizers.
 *
 * Input, all of it in host order: int64 count of integers, count of numbers, states N, motions,
 * transitions; then the layout, the numbers, and for each motion its configuration (int64) and
 * its state. Output: a line for each motion. A second argument says which call of calloc fails,
 * counted from 0: where that name is defined as failing_calloc. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine.h"

enum { KEPT = 5, GRAZINGS = 2 };

void *failing_calloc(size_t count, size_t size);

static long calls, failing = -1;

void *failing_calloc(size_t count, size_t size)
{
    void *found = calls++ == failing ? NULL : malloc(count * size + 1);
    return found ? memset(found, 0, count * size) : NULL;
}

static void *read_all(FILE *file, size_t size, size_t count)
{
    void *found = malloc(size * count + 1);
    if (!found || fread(found, size, count, file) != count) {
        fputs("cut\n", stderr);
        exit(2);
    }
    return found;
}

int main(int count, char **arguments)
{
    FILE *file = count > 1 ? fopen(arguments[1], "rb") : NULL;
    if (!file)
        return 2;
    if (count > 2)
        failing = strtol(arguments[2], NULL, 10);
    int64_t *sizes = read_all(file, sizeof *sizes, 5);
    int32_t *integers = read_all(file, sizeof *integers, (size_t)sizes[0]);
    double *numbers = read_all(file, sizeof *numbers, (size_t)sizes[1]);
    layout shape;
    tables all;
    engine_room room = {0};
    if (layout_read(&shape, integers, (size_t)sizes[0]) != 0 || shape.states != sizes[2] ||
        layout_numbers(&shape) != (size_t)sizes[1]) {
        fputs("foreign\n", stderr);
        return 2;
    }
    if (tables_create(&all, &shape) != 0 || engine_create(&room, &shape) != 0) {
        fputs("no memory\n", stderr);
        tables_free(&all);
        free(sizes);
        free(integers);
        free(numbers);
        fclose(file);
        return 3;
    }
    tables_fill(&all, numbers);
    const size_t n = (size_t)shape.states;
    /* exactly as large as promised, so that a sanitizer sees every entry beyond */
    record kept = {.capacity = KEPT,
                   .times = malloc(KEPT * sizeof(double)),
                   .configurations = malloc(KEPT * sizeof(int32_t)),
                   .before = malloc(KEPT * n * sizeof(double)),
                   .states = malloc(KEPT * n * sizeof(double)),
                   .sets = malloc(KEPT * (size_t)shape.words * sizeof(uint32_t)),
                   .grazing_capacity = GRAZINGS,
                   .grazings = malloc(GRAZINGS * 4 * sizeof(double))};
    for (int64_t i = 0; i < sizes[3]; ++i) {
        int64_t *where = read_all(file, sizeof *where, 1);
        double *state = read_all(file, sizeof *state, n);
        double *exact = malloc(n * sizeof *exact);
        int32_t configuration = (int32_t)*where;
        for (size_t k = 0; k < n; ++k)
            exact[k] = state[k];
        patience endless = {0};
        const outcome end =
            engine_run(&all, exact, &configuration, HUGE_VAL, sizes[4], &kept, NULL, &room,
                       &endless);
        printf("%d %" PRId64 " %d %.17g", end.status, end.transitions, (int)configuration, end.end);
        for (size_t k = 0; k < n; ++k)
            printf(" %.17g", exact[k]);
        printf("\n");
        free(where);
        free(state);
        free(exact);
    }
    free(kept.times);
    free(kept.configurations);
    free(kept.before);
    free(kept.states);
    free(kept.sets);
    free(kept.grazings);
    engine_free(&room);
    tables_free(&all);
    free(sizes);
    free(integers);
    free(numbers);
    fclose(file);
    return 0;
}
