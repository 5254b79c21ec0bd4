#pragma once

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <array>
#include <initializer_list>

class QComboBox;

namespace wend {

class ExactBox;

/// The recurring parts of the properties on the right: a titled section, a labelled row, a quiet line of
/// text.
QLabel* panelTitle(const QString& text, QWidget* parent);
QLabel* secondLabel(const QString& text, QWidget* parent);
QFrame* panelLine(QWidget* parent);
/// The column of a section, and a column or a row of what has no margins of its own.
QVBoxLayout* sectionColumn(QWidget* in);
QVBoxLayout* bareColumn(QWidget* in, int spacing);
QHBoxLayout* bareRow(QWidget* in, int spacing);
constexpr int kControlWidth = 116;  // pixels
/// Widgets from left to right; where one is null, the room that is left over.
QHBoxLayout* sideBySide(std::initializer_list<QWidget*> widgets);
/// Label on the left, control on the right; the label's mnemonic goes to the control. A box for a number has
/// the width of all of them.
QHBoxLayout* panelRow(const QString& label, QWidget* control, QWidget* parent);
/// The same in a widget that can be hidden.
QWidget* panelRowIn(const QString& label, QWidget* control, QWidget* parent);
/// As wide as the longest entry in the language of the window, and no less than that.
void fitToEntries(QComboBox* box, int least = kControlWidth);
/// Boxes for three coordinates side by side, each of at most so much, forward and backward.
std::array<ExactBox*, 3> coordinateBoxes(double limit, int decimals, const QString& name, const QString& help,
                                         QWidget* parent);
/// A line of two columns, for a table in a label; the value is HTML.
QString tableLine(const QString& name, const QString& value);
/// A label as it is read, without its key: "Pin" of "&Pin", and "ピン" of "ピン(&P)".
QString withoutKey(QString label);
/// Tooltip, status tip and accessible description at once.
void describe(QWidget* widget, const QString& name, const QString& help);

}  // namespace wend
