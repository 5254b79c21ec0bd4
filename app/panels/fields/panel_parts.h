#pragma once

#include <QBoxLayout>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>
#include <array>
#include <initializer_list>
#include <numbers>

#include "app/base/preferences.h"

class QComboBox;
class QToolButton;
class QVBoxLayout;

namespace wend {

class ExactBox;

/// Make the recurring parts of the properties on the right: the title of a section, a quiet label, a line.
QLabel* panelTitle(const QString& text, QWidget* parent);
QLabel* secondLabel(const QString& text, QWidget* parent);
QFrame* panelLine(QWidget* parent);
/// Make the layout of a section, and a column or a row without margins.
QVBoxLayout* sectionColumn(QWidget* in);
QVBoxLayout* bareColumn(QWidget* in, int spacing);
QHBoxLayout* bareRow(QWidget* in, int spacing);
constexpr int kControlWidth = 116;                   // pixels
constexpr double kDegrees = 180 / std::numbers::pi;  // of a radian
/// Widgets from left to right; where one is null, the room that is left over.
QHBoxLayout* sideBySide(std::initializer_list<QWidget*> widgets);
/// Returns a row with a label on the left and a control on the right; the label's mnemonic activates the
/// control. Number boxes share one width.
QHBoxLayout* panelRow(const QString& label, QWidget* control, QWidget* parent);
/// Does the same in a widget that can be hidden.
QWidget* panelRowIn(const QString& label, QWidget* control, QWidget* parent);
/// Makes a box as wide as its longest translated entry, and at least `least`.
void fitToEntries(QComboBox* box, int least = kControlWidth);
/// Makes boxes for three coordinates side by side, each limited to ±`limit`.
std::array<ExactBox*, 3> coordinateBoxes(double limit, int decimals, const QString& name, const QString& help,
                                         QWidget* parent);
/// Returns a line of two columns, for a table in a label; the value is HTML.
QString tableLine(const QString& name, const QString& value);
/// Returns a label without its mnemonic: "Pin" for "&Pin", "ピン" for "ピン(&P)".
QString withoutKey(QString label);
/// Sets tooltip, status tip and accessible description.
void describe(QWidget* widget, const QString& name, const QString& help);

/// A part of the side panel with a title that folds it; its state is stored.
class FoldingSection : public QWidget {
    Q_OBJECT

  public:
    /// `name`: of the setting that keeps whether it is open; closed at first.
    FoldingSection(const QString& title, const QString& help, const QString& name, QWidget* parent = nullptr);
    void add(QWidget* part);
    bool isOpen() const;
    void setOpen(bool open);

  private:
    QToolButton* m_title;
    QWidget* m_body;
    QVBoxLayout* m_parts;
    Preference<bool> m_isOpen;
};

}  // namespace wend
