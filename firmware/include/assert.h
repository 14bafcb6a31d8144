/* The C library's assert.h: what does not hold is printed, and the machine stops with abort(). */
#undef assert
#ifdef NDEBUG
#define assert(condition) ((void)0)
#else
#define assert(condition) \
  ((condition) ? (void)0 : assertion_failed(#condition, __FILE__, __LINE__, __func__))
#endif

#ifndef FINBACK_ASSERT_H
#define FINBACK_ASSERT_H

#ifdef __cplusplus
extern "C" {
#else
#define static_assert _Static_assert
#endif

_Noreturn void assertion_failed(const char* condition, const char* file, unsigned line,
                                const char* function);

#ifdef __cplusplus
}
#endif

#endif
