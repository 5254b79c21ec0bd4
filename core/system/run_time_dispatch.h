#pragma once

/// Before a hot function (no template, no lambda inside): compiled for several generations of processors, the
/// best one for the machine at hand taken at load time. Every sum has one order within a clone, so that
/// results repeat on one machine. Sanitizers instrument the resolvers, which run too early for them.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define WEND_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WEND_CLONES
#endif
