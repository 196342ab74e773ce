/* Sets of the boundaries of a configuration: a bit for each, in as many words as they need. */
#ifndef NONSMOOTH_SETS_H
#define NONSMOOTH_SETS_H

#include <stdint.h>

enum { WORD = 32 }; /* bits of a word */

/* The lowest member of a word that is not empty. */
static inline int lowest(uint32_t word)
{
#if defined(__GNUC__)
    return __builtin_ctz(word);
#else
    int found = 0;
    while (!(word >> found & 1))
        ++found;
    return found;
#endif
}

static inline int set_has(const uint32_t *set, int member)
{
    return (int)(set[member / WORD] >> member % WORD & 1);
}

static inline void set_put(uint32_t *set, int member)
{
    set[member / WORD] |= (uint32_t)1 << member % WORD;
}

static inline void set_clear(uint32_t *set, int words)
{
    for (int i = 0; i < words; ++i)
        set[i] = 0;
}

static inline void set_copy(uint32_t *set, const uint32_t *from, int words)
{
    for (int i = 0; i < words; ++i)
        set[i] = from[i];
}

static inline int set_is_empty(const uint32_t *set, int words)
{
    for (int i = 0; i < words; ++i)
        if (set[i])
            return 0;
    return 1;
}

/* The members of a set, one by one and rising: for (members m = members_of(set, words);
 * next_member(&m);) takes m.member. A set may change behind the word that is being read. */
typedef struct {
    const uint32_t *set;
    uint32_t rest; /* of the word */
    int words, word, member;
} members;

static inline members members_of(const uint32_t *set, int words)
{
    return (members){.set = set, .rest = set[0], .words = words};
}

/* Each turn takes a word, so that the last one ends it. */
static inline int next_member(members *m)
{
    while (!m->rest) {
        if (m->word + 1 >= m->words)
            return 0;
        m->rest = m->set[++m->word];
    }
    m->member = WORD * m->word + lowest(m->rest);
    m->rest &= m->rest - 1;
    return 1;
}

#endif
