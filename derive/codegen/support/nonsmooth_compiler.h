/* What the generated C tells compilers, each as far as it understands it. */
#ifndef NONSMOOTH_COMPILER_H
#define NONSMOOTH_COMPILER_H

/* One build serves processors with AVX-512, AVX2 and neither with -DNONSMOOTH_EVERY_PROCESSOR; it
 * takes three times as long. Builds for one of them (-mavx2, -march=native) have the same bits, with
 * -ffp-contract=off. */
#if defined(NONSMOOTH_EVERY_PROCESSOR) && defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
#define NONSMOOTH_MULTIVERSION __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define NONSMOOTH_MULTIVERSION
#endif

/* Loops over lanes use vectors with -fopenmp, or with -fopenmp-simd and -DNONSMOOTH_OPENMP_SIMD, as
 * compilers have no macro for the former. The results have the same bits without. */
#if defined(_OPENMP) || defined(NONSMOOTH_OPENMP_SIMD)
#define NONSMOOTH_PRAGMA(text) _Pragma(#text)
#define NONSMOOTH_SIMD NONSMOOTH_PRAGMA(omp simd)
#define NONSMOOTH_SIMD_SUM(total) NONSMOOTH_PRAGMA(omp simd reduction(+ : total))
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" /* what it unrolls it does not vectorise too */
#endif
#else
#define NONSMOOTH_SIMD
#define NONSMOOTH_SIMD_SUM(total)
#endif

/* A function that is copied to where it is called: what it does there to one lane becomes a loop
 * over lanes, and what the call does not ask for goes. */
#if defined(__GNUC__)
#define NONSMOOTH_INLINE inline __attribute__((always_inline))
#else
#define NONSMOOTH_INLINE inline
#endif

/* A function that is not merged with one of the same body: GCC would otherwise compare the sizes of
 * the arrays that the one is given with those that the other declares. */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
#define NONSMOOTH_UNMERGED __attribute__((no_icf))
#else
#define NONSMOOTH_UNMERGED
#endif

#endif
