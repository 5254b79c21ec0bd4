#pragma once

#include <QWidget>

#include "app/project/options/options.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace wend {

class ExactBox;

/// A control for one setting or option, made from its record in the table: its choices or range, its default
/// and all words are the table's.
class OptionField : public QWidget {
    Q_OBJECT

  public:
    explicit OptionField(std::string_view keyOrFlag, QWidget* parent = nullptr);

    const Option& option() const { return m_option; }
    std::string flag() const { return std::string(m_option.flag); }
    /// Returns the label with a mnemonic; a check box may show it itself.
    QString label() const;
    void sayLabel(bool hasKey = true);
    /// Sets the width of a number's field, which may shrink to `least` beside a long label.
    void setWidth(int usual, int least);
    QSize sizeHint() const override;
    /// Returns the value as on the command line; for a flag, a non-empty text if it is set.
    std::string value() const;
    void setValue(const std::string& value);
    /// Restricts the choices; an excluded current choice becomes the default.
    void setChoices(const QStringList& choices);
    QStringList choices() const;
    /// Shows a choice in words other than the usual ones.
    void setWords(const QString& choice, const QString& words);
    /// Enables or disables the choice at an index, with a reason.
    void allow(int place, bool allowed, const QString& why);
    /// Enables or disables the field, with a reason.
    void allow(bool allowed, const QString& why);
    /// Returns the value of any kind as a number, see Accessor; setting it emits no signal.
    double number() const;
    void setNumber(double number);
    void setRange(const Range& range);

  signals:
    /// Emitted when the user changes the value.
    void changed();

  private:
    void makeFlag();
    void makeChoice();
    void letColourBeChosen();
    void makeInteger();
    void makeNumber();
    void limitNumber();
    QString wordsFor(const QString& choice) const;

    const Option& m_option;
    Range m_range;
    int m_width = 0;  // of a number's field; 0: automatic
    QCheckBox* m_check = nullptr;
    QComboBox* m_choice = nullptr;
    int m_beforeColour = 0;  // the choice before a colour of one's own
    QSpinBox* m_integer = nullptr;
    ExactBox* m_number = nullptr;
};

}  // namespace wend
