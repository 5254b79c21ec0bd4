#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace wend {

class OptionField;

/// Why a surface bounds no solid: what is wrong, place by place, and what can be done about it. Hidden while
/// nothing is.
class SurfacePanel : public QWidget {
    Q_OBJECT

  public:
    struct Kind {
        QString name;
        int count = 0;
    };
    struct Contents {
        std::vector<Kind> kinds;
        QStringList more;  // what has no place
        bool mayRepair = false;
        QString repair;        // what it would do
        bool isCaged = false;  // the surface is embedded in a cage all the same
        int largestHole = 30;
    };
    explicit SurfacePanel(QWidget* parent = nullptr);
    void showProblems(const Contents& contents);

  signals:
    /// One of the cases of a kind is to be seen.
    void caseChosen(int kind, int number);
    /// The solid again, in place of the surface and what is wrong with it.
    void solidWanted();
    void saveRequested();
    void repairRequested(int largestHole);
    /// The surface as the repair would leave it is to be seen, or as it is.
    void repairShown(bool shown);
    /// A cage around it, or else the exact surface.
    void fitRequested(bool cage);

  private:
    void arrange();
    void describeControls();
    void connectControls();
    void step(int by);
    void tellCase();

    QLabel *m_title, *m_text, *m_case;
    QComboBox* m_kind;
    QToolButton *m_previous, *m_next;
    QPushButton *m_show, *m_save, *m_preview, *m_repair, *m_fit;
    OptionField* m_hole;
    Contents m_contents;
    int m_number = 0;
};

}  // namespace wend
