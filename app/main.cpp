#include "app/view/run_window.h"

int main(int argc, char** argv) {
    return wend::runWindow(argc, argv);
}
