/* Chains: modes whose exponents nearly meet, as in nonsmooth.runtime.model.time_functions.
 *
 * The function of a mode that is joined to the one in front of it is the divided difference of
 * e^(pt) over the exponents p up to its own. One that is paired stands for its exponent and the
 * conjugate one: its functions are the real part, and the divided difference over both. */
#ifndef NONSMOOTH_CHAIN_H
#define NONSMOOTH_CHAIN_H

#include "engine_limits.h"
#include "tables.h"

/* Values at `time` of the functions of a chain. */
void chain_functions(const mode *first, int modes, double time, double *functions);

/* Bounds on their absolute values over [from, to]; `bounds` begins with the chain. */
void chain_bounds(const mode *first, int modes, double from, double to, double *bounds);

#endif
