/* Read a system from the integers and numbers in which Python packs it. */
#include "tables.h"

#include "chain.h"
#include "factored.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest count of anything; what is there as often takes as much room. */
enum { LARGEST_COUNT = 1 << 28 };

/* Next `count` integers of the packed layout, each in [low, high]; NULL if they are not. */
static const int32_t *take(const int32_t **from, size_t *left, size_t count, int32_t low,
                           int32_t high)
{
    const int32_t *found = *from;
    if (count > *left)
        return NULL;
    for (size_t i = 0; i < count; ++i)
        if (found[i] < low || found[i] > high)
            return NULL;
    *from += count;
    *left -= count;
    return found;
}

/* Next starts: from 0 upwards to `end`; `most` becomes the largest difference of two. */
static const int32_t *take_starts(const int32_t **from, size_t *left, int owners, int end,
                                  int *most)
{
    const int32_t *found = take(from, left, (size_t)owners + 1, 0, end);
    *most = 0;
    if (!found || found[0] != 0 || found[owners] != end)
        return NULL;
    for (int i = 0; i < owners; ++i) {
        const int count = found[i + 1] - found[i];
        if (count < 0)
            return NULL;
        *most = count > *most ? count : *most;
    }
    return found;
}

/* Whether a mode of a chain is one that goes on from the one in front of it. */
static int goes_on(const layout *l, int m, int first)
{
    const int single = l->mode_length[m] == 1;
    if (l->mode_paired[m] && !(single && l->mode_oscillates[m]))
        return 0;
    if (!l->mode_joined[m])
        return single || !l->mode_oscillates[m];
    const int complex_before = !first && l->mode_oscillates[m - 1] && !l->mode_paired[m - 1];
    return !first && single && (!complex_before || (l->mode_oscillates[m] && !l->mode_paired[m]));
}

/* Whether a mode has one power of time and belongs to no chain. */
static int is_single(const layout *l, int m, int end)
{
    return l->mode_length[m] == 1 && !l->mode_joined[m] && !l->mode_paired[m] &&
           (m + 1 == end || !l->mode_joined[m + 1]);
}

int layout_read(layout *r, const int32_t *integers, size_t count)
{
    const int32_t *at = integers;
    size_t left = count;
    const int32_t *header = take(&at, &left, LAYOUT_HEADER, 0, LARGEST_COUNT);
    if (!header)
        return -1;
    r->states = header[0];
    r->configurations = header[1];
    r->rows = header[2];
    r->resets = header[3];
    r->modes = header[4];
    r->functions = header[5];
    r->boundaries = header[6];
    r->transitions = header[7];
    r->pairs = header[8];
    const int conditions = header[9], factored = header[10];
    if (r->states < 1 || r->configurations < 1)
        return -1;
    const int owners = r->configurations;
    const size_t modes = (size_t)r->modes, boundaries = (size_t)r->boundaries;
    const size_t transitions = (size_t)r->transitions, pairs = (size_t)r->pairs;
    int any;
    int whole =
        (r->mode_start = take_starts(&at, &left, owners, r->modes, &r->most_modes)) &&
        (r->mode_length = take(&at, &left, modes, 1, LARGEST_COUNT)) &&
        (r->mode_oscillates = take(&at, &left, modes, 0, 1)) &&
        (r->mode_joined = take(&at, &left, modes, 0, 1)) &&
        (r->mode_paired = take(&at, &left, modes, 0, 1)) &&
        (r->mode_factored = take(&at, &left, modes, 0, 1)) &&
        (r->function_start = take_starts(&at, &left, owners, r->functions, &r->most_functions)) &&
        (r->factored_start = take_starts(&at, &left, owners, factored, &r->most_factored)) &&
        (r->boundary_start = take_starts(&at, &left, owners, r->boundaries, &r->most_boundaries)) &&
        (r->boundary_row = take(&at, &left, boundaries, 0, r->rows - 1)) &&
        (r->boundary_reached = take(&at, &left, boundaries, 0, 1));
    if (!whole)
        return -1;
    r->words = r->most_boundaries > WORD ? (r->most_boundaries - 1) / WORD + 1 : 1;
    whole = (r->transition_start = take_starts(&at, &left, owners, r->transitions, &any)) &&
            (r->transition_set = take(&at, &left, size_product(transitions, (size_t)r->words),
                                      INT32_MIN, INT32_MAX)) &&
            (r->transition_target = take(&at, &left, transitions, 0, owners - 1)) &&
            (r->transition_reset = take(&at, &left, transitions, 0, r->resets - 1)) &&
            (r->condition_start = take_starts(&at, &left, r->transitions, conditions, &any)) &&
            (r->condition_pair = take(&at, &left, (size_t)conditions, 0, r->pairs - 1)) &&
            (r->condition_holds = take(&at, &left, (size_t)conditions, 0, 1)) &&
            (r->pair_row = take(&at, &left, pairs, 0, r->rows - 1)) &&
            (r->pair_along = take(&at, &left, pairs, 0, owners - 1)) && left == 0;
    if (!whole)
        return -1;
    for (int c = 0; c < owners; ++c) {
        int64_t functions = 0, with_factors = 0;
        int poles = 0;
        for (int m = r->mode_start[c]; m < r->mode_start[c + 1]; ++m) {
            functions += (int64_t)r->mode_length[m] << r->mode_oscillates[m];
            if (r->mode_factored[m]) {
                with_factors += 1 << r->mode_oscillates[m];
                if (!is_single(r, m, r->mode_start[c + 1]))
                    return -1;
            }
            if (!r->mode_joined[m] && !r->mode_paired[m] &&
                (m + 1 == r->mode_start[c + 1] || !r->mode_joined[m + 1]))
                continue;
            poles = (r->mode_joined[m] ? poles : 0) + r->mode_length[m] + r->mode_paired[m];
            if (poles > MOST_POLES || !goes_on(r, m, m == r->mode_start[c]))
                return -1;
        }
        if (functions != r->function_start[c + 1] - r->function_start[c] || functions < 1 ||
            with_factors != r->factored_start[c + 1] - r->factored_start[c] ||
            r->mode_oscillates[r->mode_start[c]])
            return -1;
    }
    return 0;
}

size_t layout_flows(const layout *layout, int configuration)
{
    const size_t n = (size_t)layout->states;
    const size_t factored = (size_t)layout->factored_start[configuration];
    const size_t dense = (size_t)layout->function_start[configuration] - factored;
    return size_sum(size_product(dense, size_product(n, n + 1)), size_product(factored, 2 * n + 1));
}

size_t layout_numbers(const layout *layout)
{
    const size_t columns = (size_t)layout->states + 1;
    const size_t matrix = size_product((size_t)layout->states, columns);
    const size_t matrices = (size_t)layout->configurations + (size_t)layout->resets;
    const size_t others = size_product((size_t)layout->rows, columns);
    const size_t flows = layout_flows(layout, layout->configurations);
    return size_sum(size_sum(size_product(matrices, matrix), flows),
                    size_sum(others, 2 * (size_t)layout->modes));
}

/* Room that the configurations need: rows times functions with matrices, and with factors, and
 * configurations without factors. */
typedef struct {
    size_t dense, factored, plain;
} products;

static products products_of(const layout *layout)
{
    products found = {0};
    for (int c = 0; c < layout->configurations; ++c) {
        const int boundaries = layout->boundary_start[c + 1] - layout->boundary_start[c];
        const int functions = layout->function_start[c + 1] - layout->function_start[c];
        const int factored = layout->factored_start[c + 1] - layout->factored_start[c];
        const size_t dense = (size_t)functions - (size_t)factored, rows = (size_t)boundaries;
        found.dense = size_sum(found.dense, size_product(rows, dense));
        if (factored > 0)
            found.factored = size_sum(found.factored, size_product(rows, (size_t)factored + 1));
        else
            ++found.plain;
    }
    return found;
}

int tables_create(tables *result, const layout *layout)
{
    const size_t columns = (size_t)layout->states + 1, square = size_product(columns, columns);
    const products counts = products_of(layout);
    const size_t product = size_sum(size_product(counts.dense, columns), counts.factored);
    const size_t size = size_product((size_t)layout->boundaries, columns);
    const size_t orders = size_product((size_t)layout->pairs, square);
    const size_t reach = size_product(counts.plain, square - columns);
    const size_t before = size_sum(size_sum(size_product(2, product), size), reach);
    const size_t all = size_sum(before, size_product(2, orders));
    double *room = calloc(size_sum(all, 1), sizeof *room);
    configuration *configurations = calloc((size_t)layout->configurations, sizeof *configurations);
    mode *modes = calloc((size_t)layout->modes + 1, sizeof *modes);
    const size_t rows = size_product((size_t)layout->resets, (size_t)layout->states);
    unsigned char *kept = calloc(size_sum(rows, 1), sizeof *kept);
    *result = (tables){.layout = layout,
                       .configuration = configurations,
                       .derivative = room ? room + before : NULL,
                       .bound = room ? room + before + orders : NULL,
                       .memory = room,
                       .kept = kept,
                       .mode = modes};
    if (room && configurations && modes && kept)
        return 0;
    tables_free(result);
    return -1;
}

void tables_free(tables *tables)
{
    free(tables->memory);
    free(tables->configuration);
    free(tables->mode);
    free(tables->kept);
    tables->memory = NULL;
    tables->configuration = NULL;
    tables->mode = NULL;
    tables->kept = NULL;
}

/* Radians of the fastest exponent in one cell; the bound on a cell errs by its fourth power. */
static const double CELL = 1.0;

static void fill_modes(configuration *c, mode *modes, const double *exponents)
{
    int function = 0, lengths = 0, factored = 0;
    c->fastest = c->slowest = c->growth = c->steepest = 0.0;
    c->uniform = c->harmonic = 1;
    c->chained = 0;
    for (int m = 0; m < c->modes; ++m) {
        mode *one = &modes[m];
        one->rate = exponents[2 * m];
        one->frequency = exponents[2 * m + 1];
        one->first = function;
        one->place = one->factored ? factored : function - factored;
        function += one->length << one->oscillates;
        factored += one->factored << one->oscillates;
        lengths += one->length;
        const double speed = hypot(one->rate, one->frequency);
        c->fastest = speed <= c->fastest ? c->fastest : speed <= DBL_MAX ? speed : HUGE_VAL;
        c->growth = one->rate > c->growth ? one->rate : c->growth;
        c->steepest = fabs(one->rate) > c->steepest ? fabs(one->rate) : c->steepest;
        if (speed > 0.0 && (c->slowest == 0.0 || speed < c->slowest))
            c->slowest = speed;
        if (one->rate > 0.0 || (m > 0 && one->length > 1))
            c->uniform = 0;
        if (one->rate != 0.0 || one->length > (m > 0 ? 1 : 2))
            c->harmonic = 0;
        int end = m + 1;
        while (end < c->modes && modes[end].joined)
            ++end;
        one->chain = !one->joined && (end > m + 1 || one->paired) ? end - m : 0;
        c->chained |= one->chain > 0;
    }
    if (c->chained)
        c->uniform = c->harmonic = 0;
    c->mode = modes;
    c->polynomial = c->modes == 1 ? lengths - 1 : -1;
    /* the fourth derivative of a cubic vanishes, whatever the time */
    if (modes[0].length > 4)
        c->uniform = 0;
    c->simple = c->uniform && modes[0].length <= 2;
    c->cell = c->fastest > 0.0 ? CELL / c->fastest : 1.0;
    /* powers of the fastest exponent are out of range soon, in this unit they stay near 1 */
    c->unit = c->fastest > 1e-150 && c->fastest < 1e150 ? ldexp(1.0, -ilogb(c->fastest)) : 1.0;
    for (int m = 0; m < c->modes; ++m) {
        const double growth = exp(modes[m].rate * c->cell), turn = modes[m].frequency * c->cell;
        modes[m].cell_cosine = growth * cos(turn);
        modes[m].cell_sine = growth * sin(turn);
    }
}

/* Derivatives of order 0, ..., N of an affine function along a flow y' = A y + b, in a unit of
 * time. */
static void fill_orders(int n, const double *row, const double *field, double unit, double *value,
                        double *bound)
{
    const int columns = n + 1;
    for (int i = 0; i < columns; ++i) {
        value[i] = row[i];
        bound[i] = fabs(row[i]);
    }
    for (int k = 1; k < columns; ++k) {
        const double *before = value, *above = bound, *from = field;
        value += columns;
        bound += columns;
        for (int j = 0; j < columns; ++j)
            value[j] = bound[j] = 0.0;
        for (int i = 0; i < n; ++i, from += columns)
            for (int j = 0; j < columns; ++j) {
                value[j] += before[i] * from[j];
                bound[j] += above[i] * fabs(from[j]);
            }
        for (int j = 0; j < columns; ++j) {
            value[j] *= unit;
            bound[j] *= unit;
        }
    }
}

/* Coefficients of a boundary's function by the state, and the same of absolute values: of one
 * function of time. */
static void fill_boundary(int n, const double *row, const double *flow, int is_constant,
                          double *boundary, double *weight)
{
    const int columns = n + 1;
    for (int j = 0; j < columns; ++j)
        boundary[j] = weight[j] = 0.0;
    for (int k = 0; k < n; ++k, flow += columns)
        for (int j = 0; j < columns; ++j) {
            const double product = row[k] * flow[j];
            boundary[j] += product;
            weight[j] += fabs(product);
        }
    if (is_constant) {
        boundary[n] += row[n];
        weight[n] += fabs(row[n]);
    }
}

static int functions_of(const mode *m)
{
    return m->length << m->oscillates;
}

/* Whether a function of a mode is 1 or less, and not t^k or a difference, whose unit is one of time. */
static int has_no_unit(const mode *m, int part)
{
    return !m->joined && (m->paired ? part == 0 : part <= m->oscillates);
}

/* Whether a row of a reset keeps a state as it is. */
static unsigned char keeps(int n, const double *row, int state)
{
    for (int j = 0; j <= n; ++j)
        if (row[j] != (j == state ? 1.0 : 0.0))
            return 0;
    return 1;
}

void tables_fill(tables *tables, const double *numbers)
{
    const layout *l = tables->layout;
    const int n = l->states;
    const size_t columns = (size_t)n + 1, matrix = (size_t)n * columns;
    const double *fields = numbers;
    const double *rows = fields + (size_t)l->configurations * matrix;
    const double *resets = rows + (size_t)l->rows * columns;
    const double *exponents = resets + (size_t)l->resets * matrix;
    const double *flows = exponents + 2 * (size_t)l->modes;
    const products counts = products_of(l);
    double *boundary = tables->memory;
    double *weight = boundary + counts.dense * columns;
    double *across = weight + counts.dense * columns;
    double *spread = across + counts.factored;
    double *size = spread + counts.factored;
    double *reach = size + (size_t)l->boundaries * columns;
    tables->fields = fields;
    tables->resets = resets;
    for (int i = 0; i < l->configurations; ++i) {
        configuration *c = &tables->configuration[i];
        c->modes = l->mode_start[i + 1] - l->mode_start[i];
        c->functions = l->function_start[i + 1] - l->function_start[i];
        c->boundaries = l->boundary_start[i + 1] - l->boundary_start[i];
        for (int m = 0; m < c->modes; ++m) {
            const int at = l->mode_start[i] + m;
            tables->mode[at].length = l->mode_length[at];
            tables->mode[at].oscillates = l->mode_oscillates[at];
            tables->mode[at].joined = l->mode_joined[at];
            tables->mode[at].paired = l->mode_paired[at];
            tables->mode[at].factored = l->mode_factored[at];
        }
        fill_modes(c, tables->mode + l->mode_start[i], exponents + 2 * (size_t)l->mode_start[i]);
        c->factored = l->factored_start[i + 1] - l->factored_start[i];
        c->dense = c->functions - c->factored;
        c->flow = flows + layout_flows(l, i);
        c->left = c->flow + (size_t)c->dense * matrix;
        c->right = c->left + (size_t)c->factored * (size_t)n;
        c->boundary = boundary;
        c->weight = weight;
        c->size = size;
        c->across = across;
        c->spread = spread;
        c->reach = c->factored ? NULL : reach;
        if (!c->factored) {
            for (size_t k = 0; k < matrix; ++k)
                reach[k] = 0.0;
            for (int m = 0; m < c->modes; ++m)
                for (int part = 0; part < functions_of(&c->mode[m]); ++part)
                    for (size_t k = 0; k < matrix && has_no_unit(&c->mode[m], part); ++k)
                        reach[k] += fabs(c->flow[(size_t)(c->mode[m].first + part) * matrix + k]);
            reach += matrix;
        }
        for (int b = 0; b < c->boundaries; ++b) {
            const double *row = rows + (size_t)l->boundary_row[l->boundary_start[i] + b] * columns;
            memset(size, 0, columns * sizeof *size);
            const double *flow = c->flow;
            for (int m = 0; m < c->modes; ++m) {
                const mode *one = &c->mode[m];
                for (int part = 0; part < functions_of(one) && !one->factored; ++part) {
                    /* the constant joins the function 1 */
                    fill_boundary(n, row, flow, m == 0 && part == 0, boundary, weight);
                    for (size_t j = 0; j < columns && has_no_unit(one, part); ++j)
                        size[j] += weight[j];
                    flow += matrix;
                    boundary += columns;
                    weight += columns;
                }
            }
            if (c->factored) {
                factored_boundary(c, n, row, across, spread, size);
                across += c->factored + 1;
                spread += c->factored + 1;
            }
            size += columns;
        }
    }
    for (int r = 0; r < l->resets; ++r)
        for (int k = 0; k < n; ++k)
            tables->kept[r * n + k] = keeps(n, resets + (size_t)r * matrix + (size_t)k * columns, k);
    for (int p = 0; p < l->pairs; ++p)
        fill_orders(n, rows + (size_t)l->pair_row[p] * columns,
                    fields + (size_t)l->pair_along[p] * matrix,
                    tables->configuration[l->pair_along[p]].unit,
                    tables->derivative + (size_t)p * columns * columns,
                    tables->bound + (size_t)p * columns * columns);
}
