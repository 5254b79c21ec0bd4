#include "app/panels/look/liveliness.h"

#include <QApplication>
#include <QStyle>

namespace wend {
namespace {

bool wanted = false;  // until a window says so

}  // namespace

bool isLively() {
    return wanted && QApplication::style()->styleHint(QStyle::SH_Widget_Animation_Duration) > 0;
}

void setLively(bool lively) {
    wanted = lively;
}

}  // namespace wend
