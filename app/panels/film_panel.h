#pragma once

#include <QWidget>

#include "app/project/edits/document.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace wend {

class ExactBox;
class OptionField;

/// The film that the motion becomes: its frame rate, the part of time that repeats, and its sound.
class FilmPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FilmPanel(Document& document, QWidget* parent = nullptr);

    /// Takes the file as the film's sound; an empty path removes the sound.
    void setSound(const QString& path);

  private:
    void makeCycle();
    void showProject();
    void changeCycle(const QString& name);
    void chooseSound();

    Document& m_document;
    OptionField* m_rate;
    QCheckBox* m_cycles;
    ExactBox *m_from, *m_to;
    QWidget* m_cycle;  // the row of both
    QLabel* m_sound;
    QPushButton *m_choose, *m_remove;
};

}  // namespace wend
