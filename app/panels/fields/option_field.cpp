#include "app/panels/fields/option_field.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <cmath>

#include "app/panels/fields/controls.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"

namespace wend {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("Options", text);
}

/// Makes a sentence of the table's phrase.
QString sentence(std::string_view meaning) {
    QString text = translated(std::string(meaning).c_str());
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text + '.';
}

}  // namespace

OptionField::OptionField(std::string_view keyOrFlag, QWidget* parent)
    : QWidget(parent), m_option(wend::option(keyOrFlag)) {
    setObjectName(QString::fromStdString(std::string(keyOrFlag)));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    const Row& words = m_option.row;
    if (words.words[0])
        makeChoice();
    else if (m_option.kind == OptionKind::Flag)
        makeFlag();
    else
        m_option.kind == OptionKind::Integer ? makeInteger() : makeNumber();
    setFocusProxy(findChild<QWidget*>());
    describe(focusProxy(), *words.name ? translated(words.name) : withoutKey(label()),
             *words.help ? translated(words.help) : sentence(m_option.meaning));
    setToolTip(focusProxy()->toolTip());
    row->addWidget(focusProxy());
}

QString OptionField::label() const {
    return translated(m_option.row.label);
}

void OptionField::sayLabel(bool hasKey) {
    if (m_check) m_check->setText(hasKey ? label() : withoutKey(label()));
}

void OptionField::setWidth(int usual, int least) {
    setMinimumWidth(least);
    setMaximumWidth(usual);
    m_width = usual;
}

QSize OptionField::sizeHint() const {
    const QSize own = QWidget::sizeHint();
    return {m_width > 0 ? m_width : own.width(), own.height()};
}

/// Returns the table's word for a choice, or the choice itself.
QString OptionField::wordsFor(const QString& choice) const {
    const int place = placeOf(m_option, choice.toStdString());
    const char* words =
        place < static_cast<int>(m_option.row.words.size()) ? m_option.row.words[place] : nullptr;
    return words ? translated(words) : choice;
}

void OptionField::makeFlag() {
    m_check = checkBox(this, "", {}, {}, &OptionField::changed);
}

/// Makes a combo box. Options without choices show the words of their indices.
void OptionField::makeChoice() {
    m_choice = new QComboBox(this);
    for (const std::string& choice : choicesOf(m_option))
        m_choice->addItem(wordsFor(QString::fromStdString(choice)), QString::fromStdString(choice));
    for (std::size_t i = m_choice->count(); i < m_option.row.words.size() && m_option.row.words[i]; ++i)
        m_choice->addItem(translated(m_option.row.words[i]));
    setValue(defaultText(m_option));
    if (m_option.kind == OptionKind::Colour) letColourBeChosen();
    connect(m_choice, &QComboBox::currentIndexChanged, this, &OptionField::changed);
}

/// Lets the last entry open a colour dialog; cancelling restores the previous choice.
void OptionField::letColourBeChosen() {
    const int other = m_choice->count() - 1;
    m_choice->setItemData(other, QStringLiteral("#808080"));
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this, other](int index) {
        if (index != other) m_beforeColour = index;
    });
    connect(m_choice, &QComboBox::activated, this, [this, other](int index) {
        if (index != other) return;
        const QColor before(m_choice->itemData(other).toString());
        const QColor chosen = QColorDialog::getColor(before, this, withoutKey(label()));
        if (!chosen.isValid()) return m_choice->setCurrentIndex(m_beforeColour);
        m_choice->setItemData(other, chosen.name());
        QPixmap patch(m_choice->iconSize());
        patch.fill(chosen);
        m_choice->setItemIcon(other, patch);
        emit changed();
    });
}

void OptionField::makeInteger() {
    m_integer = new QSpinBox(this);
    m_integer->setSingleStep(static_cast<int>(m_option.row.step));
    m_integer->setGroupSeparatorShown(true);
    m_integer->setAccelerated(true);
    setRange(m_option.range);
    setNumber(defaultOf(m_option));
    connect(m_integer, &QSpinBox::valueChanged, this, &OptionField::changed);
}

void OptionField::makeNumber() {
    const Row& row = m_option.row;
    m_number = row.anySize ? new MagnitudeBox(this) : new ExactBox(this);
    if (!row.anySize) m_number->setDecimals(row.decimals);
    m_number->setSingleStep(row.step);
    m_number->setSuffix(translated(row.unit));
    m_number->setSpecialValueText(translated(row.zero));
    setRange(m_option.range);
    setNumber(defaultOf(m_option));
    connect(m_number, &QDoubleSpinBox::valueChanged, this, &OptionField::changed);
}

void OptionField::allow(int place, bool allowed, const QString& why) {
    QStandardItem* item = qobject_cast<QStandardItemModel*>(m_choice->model())->item(place);
    item->setEnabled(allowed);
    item->setToolTip(allowed ? QString() : why);
}

void OptionField::allow(bool allowed, const QString& why) {
    setEnabled(allowed);
    wend::allow(focusProxy(), allowed, why);
    setToolTip(focusProxy()->toolTip());
}

void OptionField::setRange(const Range& range) {
    m_range = range;
    const QSignalBlocker quiet(this);
    if (m_integer) m_integer->setRange(static_cast<int>(range.min), static_cast<int>(range.max));
    if (m_number && !m_option.row.anySize) limitNumber();
}

/// Keeps the number one digit away from an open end; the box limits infinite ranges.
void OptionField::limitNumber() {
    constexpr double kMostShown = 1e9;
    const double digit = std::pow(0.1, m_number->decimals()), factor = m_option.row.factor;
    const double minimum = std::max(-kMostShown, factor * m_range.min) + (m_range.openMin ? digit : 0);
    m_number->setRange(*m_option.row.zero ? 0 : minimum,
                       std::min(kMostShown, factor * m_range.max) - (m_range.openMax ? digit : 0));
}

std::string OptionField::value() const {
    if (m_check) return m_check->isChecked() ? flag() : std::string();
    return m_choice ? m_choice->currentData().toString().toStdString() : shortNumber(number());
}

void OptionField::setValue(const std::string& value) {
    m_choice->setCurrentIndex(std::max(0, m_choice->findData(QString::fromStdString(value))));
}

void OptionField::setChoices(const QStringList& choices) {
    if (choices == this->choices()) return;
    const QString before = m_choice->currentData().toString();
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    for (const QString& choice : choices) m_choice->addItem(wordsFor(choice), choice);
    setValue(choices.contains(before) ? before.toStdString() : defaultText(m_option));
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
    if (m_check) return m_check->isChecked();
    if (m_choice) return m_choice->currentIndex();
    return m_integer ? m_integer->value() : m_number->exact() / m_option.row.factor;
}

/// Shows more digits for a number that is too small for those of the row.
void OptionField::setNumber(double number) {
    const QSignalBlocker quiet(focusProxy() ? focusProxy() : this), also(this);
    if (m_check) m_check->setChecked(number != 0);
    if (m_choice) m_choice->setCurrentIndex(static_cast<int>(number));
    if (m_integer) m_integer->setValue(static_cast<int>(number));
    if (!m_number) return;
    const double shown = number * m_option.row.factor;
    const int needed = shown == 0 ? 0 : 1 - static_cast<int>(std::floor(std::log10(std::abs(shown))));
    if (!m_option.row.anySize) {
        const int usual = m_option.row.decimals;
        m_number->showDigits(needed > usual + 1 ? std::min(needed, 12) : usual);
        limitNumber();
    }
    m_number->put(shown);
}

}  // namespace wend
