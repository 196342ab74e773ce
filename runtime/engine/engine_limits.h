/* Limits of both engines: Python reads them from here (runtime/model/engine_run.py). */
#ifndef NONSMOOTH_ENGINE_LIMITS_H
#define NONSMOOTH_ENGINE_LIMITS_H

#define LARGEST_STATE 1e150 /* its squares are finite */
#define LONGEST_WAIT 1e5 /* radians of the fastest exponent that are searched at once */
#define LONGEST_QUIET 3199999.9968 /* without a transition, or LONGEST_WAIT of the slowest */
#define FARTHEST_END 1e11 /* radians to an end beyond which it is none */
#define GROWTH 100.0 /* exponent of the largest growth that is searched at once */
#define MOST_AT_ONCE 100 /* transitions in a row without time between them */
#define ORDERS 24 /* of a Taylor series: more than one radian needs */
#define MOST_POLES 7 /* of a chain, conjugates and equal ones counted */

#endif
