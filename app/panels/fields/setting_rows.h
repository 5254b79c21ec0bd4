#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <string_view>

class QWidget;

namespace wend {

class Document;
class OptionField;

/// The settings of a panel: fields made from the option table that show the document's values, are visible
/// for projects with that setting, and change it in undo steps.
class SettingRows : public QObject {
    Q_OBJECT

  public:
    /// `whyNot`: the reason shown for settings that a project does not have.
    SettingRows(Document& document, QWidget* panel, QString whyNot = {});

    /// Makes a widget with label and field side by side.
    QWidget* row(std::string_view key);
    OptionField& field(std::string_view key) const { return *m_fields.at(key); }
    /// Shows and changes the settings of one part of the picture instead; −1: those of all.
    void setPart(int part) { m_part = part; }
    /// Call this after every change of the project.
    void show();

  private:
    Document& m_document;
    QWidget* m_panel;
    QString m_whyNot;
    int m_part = -1;
    std::map<std::string_view, OptionField*> m_fields;
};

}  // namespace wend
