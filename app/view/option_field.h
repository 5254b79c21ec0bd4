#pragma once

#include <QWidget>

#include "app/document/options.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace wend {

class ExactBox;

/// A control for one option of the command line, made from the table of options: its choices or range, its
/// default and its meaning are the table's; only the words are the window's.
class OptionField : public QWidget {
    Q_OBJECT

  public:
    explicit OptionField(const char* flag, QWidget* parent = nullptr);

    std::string flag() const { return m_flag; }
    /// What stands beside it, with a mnemonic.
    QString label() const;
    /// As one would write it on the command line; of a flag something if it is given, and nothing if not.
    std::string value() const;
    void setValue(const std::string& value);
    /// Only these choices can be taken; another one that was taken gives way to the default.
    void setChoices(const QStringList& choices);
    QStringList choices() const;
    /// A choice in other words than usual.
    void setWords(const QString& choice, const QString& words);
    double number() const;
    void setNumber(double number);

  signals:
    void changed();

  private:
    void makeFlag();
    void makeChoice();
    void makeNumber();

    std::string m_flag;
    const Option& m_option;
    QCheckBox* m_check = nullptr;
    QComboBox* m_choice = nullptr;
    QSpinBox* m_integer = nullptr;
    ExactBox* m_number = nullptr;
};

}  // namespace wend
