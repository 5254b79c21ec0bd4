#include "app/style/mark_size.h"

namespace wend {
namespace {

double chosen = 1;

}  // namespace

double markSize() {
    return chosen;
}

void setMarkSize(double factor) {
    chosen = factor;
}

}  // namespace wend
