#include "app/view/option_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QSpinBox>
#include <limits>

#include "app/panels/exact_box.h"
#include "app/panels/panel_parts.h"

namespace wend {

namespace {

struct Words {
    const char *flag, *choice, *text;
};

/// What a person reads instead of the command line's names.
constexpr Words kWords[] = {
    {"--filter", "", QT_TRANSLATE_NOOP("wend::OptionField", "Fil&ter")},
    {"--filter", "nearest", QT_TRANSLATE_NOOP("wend::OptionField", "Nearest – hard pixels")},
    {"--filter", "bilinear", QT_TRANSLATE_NOOP("wend::OptionField", "Bilinear – quick")},
    {"--filter", "bicubic", QT_TRANSLATE_NOOP("wend::OptionField", "Bicubic – sharp")},
    {"--filter", "ewa", QT_TRANSLATE_NOOP("wend::OptionField", "EWA – best")},
    {"--canvas", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Canvas")},
    {"--canvas", "picture", QT_TRANSLATE_NOOP("wend::OptionField", "As large as the picture")},
    {"--canvas", "fit", QT_TRANSLATE_NOOP("wend::OptionField", "Fit to the shape")},
    {"--depth", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Depth")},
    {"--depth", "picture", QT_TRANSLATE_NOOP("wend::OptionField", "As in the picture")},
    {"--depth", "8", QT_TRANSLATE_NOOP("wend::OptionField", "8 bit")},
    {"--depth", "16", QT_TRANSLATE_NOOP("wend::OptionField", "16 bit")},
    {"--depth", "half", QT_TRANSLATE_NOOP("wend::OptionField", "16 bit floating point (half)")},
    {"--depth", "float", QT_TRANSLATE_NOOP("wend::OptionField", "32 bit floating point")},
    {"--outside", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Background")},
    {"--outside", "transparent", QT_TRANSLATE_NOOP("wend::OptionField", "Transparent")},
    {"--outside", "clamp", QT_TRANSLATE_NOOP("wend::OptionField", "The border, drawn out")},
    {"--outside", "original", QT_TRANSLATE_NOOP("wend::OptionField", "The picture as it was")},
    {"--outside", "white", QT_TRANSLATE_NOOP("wend::OptionField", "White")},
    {"--outside", "black", QT_TRANSLATE_NOOP("wend::OptionField", "Black")},
    {"--fields", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Values")},
    {"--fields", "all", QT_TRANSLATE_NOOP("wend::OptionField", "Errors, material, velocity")},
    {"--fields", "none", QT_TRANSLATE_NOOP("wend::OptionField", "The shape alone")},
    {"--encoding", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Numbers")},
    {"--encoding", "text", QT_TRANSLATE_NOOP("wend::OptionField", "As text")},
    {"--encoding", "binary", QT_TRANSLATE_NOOP("wend::OptionField", "Binary")},
    {"--encoding", "compressed", QT_TRANSLATE_NOOP("wend::OptionField", "Binary, compressed")},
    {"--msh", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Gmsh version")},
    {"--border", "", QT_TRANSLATE_NOOP("wend::OptionField", "&Border triangles")},
    {"--count", "", QT_TRANSLATE_NOOP("wend::OptionField", "F&rames")},
    {"--fps", "", QT_TRANSLATE_NOOP("wend::OptionField", "Frames per &second")},
};

QString wordsFor(const std::string& flag, const QString& choice) {
    for (const Words& one : kWords)
        if (flag == one.flag && choice == QLatin1String(one.choice)) return OptionField::tr(one.text);
    return choice;
}

/// The table speaks in half sentences.
QString sentence(std::string_view meaning) {
    QString text = QCoreApplication::translate("Options", std::string(meaning).c_str());
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text + '.';
}

}  // namespace

OptionField::OptionField(const char* flag, QWidget* parent)
    : QWidget(parent), m_flag(flag), m_option(option(flag)) {
    setObjectName(QString::fromLatin1(flag));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    if (m_option.kind == OptionKind::Flag)
        makeFlag();
    else
        m_option.kind == OptionKind::Choice ? makeChoice() : makeNumber();
    setFocusProxy(findChild<QWidget*>());
    describe(focusProxy(), label().remove('&'), sentence(m_option.meaning));
    setToolTip(focusProxy()->toolTip());
    row->addWidget(focusProxy());
}

QString OptionField::label() const {
    return wordsFor(m_flag, {});
}

void OptionField::makeFlag() {
    m_check = new QCheckBox(this);
    connect(m_check, &QCheckBox::toggled, this, &OptionField::changed);
}

void OptionField::makeChoice() {
    m_choice = new QComboBox(this);
    setChoices(QString::fromUtf8(m_option.choices.data(), static_cast<qsizetype>(m_option.choices.size()))
                   .split('|'));
    setValue(std::string(m_option.fallback));
    connect(m_choice, &QComboBox::currentIndexChanged, this, &OptionField::changed);
}

void OptionField::makeNumber() {
    const Range& range = m_option.range;
    if (m_option.kind == OptionKind::Integer) {
        m_integer = new QSpinBox(this);
        m_integer->setRange(static_cast<int>(range.min), static_cast<int>(range.max));
        m_integer->setValue(static_cast<int>(defaultOf(m_flag)));
        connect(m_integer, &QSpinBox::valueChanged, this, &OptionField::changed);
        return;
    }
    constexpr double kMost = 1e6, kLeast = 0.01;  // what a box shows of an endless range
    m_number = new ExactBox(this);
    m_number->setRange(range.openMin ? kLeast : range.min, std::min(range.max, kMost));
    m_number->put(defaultOf(m_flag));
    connect(m_number, &QDoubleSpinBox::valueChanged, this, &OptionField::changed);
}

std::string OptionField::value() const {
    if (m_check) return m_check->isChecked() ? m_flag : std::string();
    return m_choice ? m_choice->currentData().toString().toStdString() : shortNumber(number());
}

void OptionField::setValue(const std::string& value) {
    m_choice->setCurrentIndex(std::max(0, m_choice->findData(QString::fromStdString(value))));
}

void OptionField::setChoices(const QStringList& choices) {
    if (choices == this->choices()) return;
    const QString before = m_choice->currentData().toString();
    const QString fallback =
        QString::fromUtf8(m_option.fallback.data(), static_cast<qsizetype>(m_option.fallback.size()));
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    for (const QString& choice : choices) m_choice->addItem(wordsFor(m_flag, choice), choice);
    setValue((choices.contains(before) ? before : fallback).toStdString());
}

QStringList OptionField::choices() const {
    QStringList all;
    for (int i = 0; m_choice && i < m_choice->count(); ++i) all << m_choice->itemData(i).toString();
    return all;
}

void OptionField::setWords(const QString& choice, const QString& words) {
    if (const int at = m_choice->findData(choice); at >= 0) m_choice->setItemText(at, words);
}

double OptionField::number() const {
    return m_integer ? m_integer->value() : m_number->exact();
}

void OptionField::setNumber(double number) {
    if (m_integer) {
        const QSignalBlocker quiet(m_integer);
        m_integer->setValue(static_cast<int>(number));
    } else {
        m_number->put(number);
    }
}

}  // namespace wend
