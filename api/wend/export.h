#pragma once

/// Marks what libwend shows: everything else is hidden in it.
#define WEND_API __attribute__((visibility("default")))
