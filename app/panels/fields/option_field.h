#pragma once

#include <QWidget>

#include "app/document/options/options.h"

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
    /// What stands beside it, with a mnemonic; a box to be checked may say it itself.
    QString label() const;
    void sayLabel(bool hasKey = true);
    /// Of a number: so wide, or down to so much narrower where its label is long.
    void setWidth(int usual, int least);
    QSize sizeHint() const override;
    /// As one would write it on the command line; of a flag something if it is given, and nothing if not.
    std::string value() const;
    void setValue(const std::string& value);
    /// Only these choices can be taken; another one that was taken gives way to the default.
    void setChoices(const QStringList& choices);
    QStringList choices() const;
    /// A choice in other words than usual.
    void setWords(const QString& choice, const QString& words);
    /// Whether the choice at that place can be taken, and why not.
    void allow(int place, bool allowed, const QString& why);
    /// Whether it can be changed at all, and why not.
    void allow(bool allowed, const QString& why);
    /// A value of any kind as in a project, see Accessor; setting it tells nobody.
    double number() const;
    void setNumber(double number);
    void setRange(const Range& range);

  signals:
    /// By the user.
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
    int m_width = 0;  // of a number; 0: as it comes
    QCheckBox* m_check = nullptr;
    QComboBox* m_choice = nullptr;
    int m_beforeColour = 0;  // the choice before a colour of one's own
    QSpinBox* m_integer = nullptr;
    ExactBox* m_number = nullptr;
};

}  // namespace wend
