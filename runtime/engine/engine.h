/* One motion from event to event: the rules of nonsmooth.runtime.simulation.stepping, compiled. */
#ifndef NONSMOOTH_ENGINE_H
#define NONSMOOTH_ENGINE_H

#include "patience.h"
#include "phase.h"
#include "tables.h"

/* The members of nonsmooth.runtime.model.engine_run.Status. */
enum {
    STATUS_TRANSITIONS,
    STATUS_UNTIL,
    STATUS_QUIET,
    STATUS_UNDECLARED,
    STATUS_IMMEDIATE,
    STATUS_OVERFLOW,
    STATUS_AMBIGUOUS,
    STATUS_UNFINISHED = -1, /* no member: the caller wanted it to end */
};

/* What follows an event for which no transition is listed: the target and the index of the reset,
 * and a negative number; or the status with which the motion ends. */
typedef struct {
    int (*decide)(void *context, int source, const uint32_t *set, const double *state,
                  const double *magnitude, double time_error, int32_t *target, int32_t *reset);
    void *context;
} decider;

/* Where the entries go: entry k at k % capacity, so that the last ones stay; any may be NULL. */
typedef struct {
    int64_t capacity;
    double *times;           /* [capacity] */
    int32_t *configurations; /* [capacity] */
    double *before, *states; /* [capacity][states] */
    uint32_t *sets;          /* [capacity][words] */
    int64_t grazing_capacity;
    double *grazings; /* [grazing_capacity][4]: time, configuration, boundary, depth */
} record;

typedef struct {
    int status;
    int64_t transitions, grazings;
    double end;
} outcome;

/* Room for one motion at a time. */
typedef struct {
    phase phase;
    uint32_t *located;
    double *magnitude; /* [3 * states]: of a state, then two states */
    double *result;    /* [2 * states]: what is added up */
    double *moved;     /* [states] */
} engine_room;

/* 0, or -1 if there is no memory. */
int engine_create(engine_room *room, const layout *layout);

void engine_free(engine_room *room);

/* Follow a motion. `state` and `configuration` are those of the end afterwards. At most `limit`
 * transitions, and no further than `until`, which may be infinite. Without a decider (NULL) a motion
 * ends where no transition is listed. Whether to go on is asked every few microseconds. */
outcome engine_run(const tables *tables, double *state, int32_t *configuration, double until,
                   int64_t limit, const record *record, const decider *decider,
                   engine_room *room, patience *patience);

#endif
