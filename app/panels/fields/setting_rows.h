#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <string_view>

class QWidget;

namespace wend {

class Document;
class OptionField;

/// The settings of a panel, each a field made from its record in the table: it shows what the document has,
/// is there for projects that have the setting, and a change of it is an undo step.
class SettingRows : public QObject {
    Q_OBJECT

  public:
    /// `whyNot`: why what a project does not have cannot be changed.
    SettingRows(Document& document, QWidget* panel, QString whyNot = {});

    /// Label and field, side by side in a widget.
    QWidget* row(std::string_view key);
    OptionField& field(std::string_view key) const { return *m_fields.at(key); }
    /// To be called after every change of the project.
    void show();

  private:
    Document& m_document;
    QWidget* m_panel;
    QString m_whyNot;
    std::map<std::string_view, OptionField*> m_fields;
};

}  // namespace wend
