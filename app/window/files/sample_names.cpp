#include "app/window/files/sample_names.h"

#include <QCoreApplication>

#include "app/project/edits/handle_edits.h"

namespace wend {

namespace {

// Names in the samples.
[[maybe_unused]] constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("SampleNames", "back"),
    QT_TRANSLATE_NOOP("SampleNames", "body"),
    QT_TRANSLATE_NOOP("SampleNames", "chest"),
    QT_TRANSLATE_NOOP("SampleNames", "face"),
    QT_TRANSLATE_NOOP("SampleNames", "far front hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "far hand"),
    QT_TRANSLATE_NOOP("SampleNames", "far heel"),
    QT_TRANSLATE_NOOP("SampleNames", "far hind hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "far toe"),
    QT_TRANSLATE_NOOP("SampleNames", "front hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "head"),
    QT_TRANSLATE_NOOP("SampleNames", "hind hoof"),
    QT_TRANSLATE_NOOP("SampleNames", "left elbow"),
    QT_TRANSLATE_NOOP("SampleNames", "left end"),
    QT_TRANSLATE_NOOP("SampleNames", "left eye"),
    QT_TRANSLATE_NOOP("SampleNames", "left foot"),
    QT_TRANSLATE_NOOP("SampleNames", "left hand"),
    QT_TRANSLATE_NOOP("SampleNames", "left lower arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left middle arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left upper arm"),
    QT_TRANSLATE_NOOP("SampleNames", "left wing"),
    QT_TRANSLATE_NOOP("SampleNames", "near hand"),
    QT_TRANSLATE_NOOP("SampleNames", "near heel"),
    QT_TRANSLATE_NOOP("SampleNames", "near toe"),
    QT_TRANSLATE_NOOP("SampleNames", "right end"),
    QT_TRANSLATE_NOOP("SampleNames", "right eye"),
    QT_TRANSLATE_NOOP("SampleNames", "right foot"),
    QT_TRANSLATE_NOOP("SampleNames", "right lower arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right middle arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right upper arm"),
    QT_TRANSLATE_NOOP("SampleNames", "right wing"),
    QT_TRANSLATE_NOOP("SampleNames", "rump"),
    QT_TRANSLATE_NOOP("SampleNames", "shadow"),
    QT_TRANSLATE_NOOP("SampleNames", "shoulder"),
    QT_TRANSLATE_NOOP("SampleNames", "stiff"),
    QT_TRANSLATE_NOOP("SampleNames", "tail"),
};

}  // namespace

std::shared_ptr<const Project> withSpokenNames(const std::shared_ptr<const Project>& sample) {
    return withNames(sample, [](const std::string& name) {
        return QCoreApplication::translate("SampleNames", name.c_str()).toStdString();
    });
}

}  // namespace wend
