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
        QStringList more;      // what has no place
        bool isCaged = false;  // the surface is embedded in a cage nonetheless
        int largestHole = 30;
        int kind = 0, number = 0;  // the place to begin with
    };
    explicit SurfacePanel(QWidget* parent = nullptr);
    void showProblems(const Contents& contents);
    /// Whether the repair of all leaves a surface that bounds a solid, and what it would do.
    void tellOfRepair(bool helps, const QString& repair);
    int largestHole() const;
    /// Looks at the place where it is.
    void showPlace() { step(0); }
    /// What could be done about this place alone; while that is not known it is not offered.
    void showFix(const QString& text, bool mayFix);
    /// And about all of its kind.
    void showFixOfAll(const QString& text, bool mayFix);
    /// The solid is seen again in place of the surface. False if it was seen already.
    bool leave();

  signals:
    /// What is wrong is told: with a cage around it all the rest can go on.
    void told(bool isCaged);
    /// One of the cases of a kind is to be seen.
    void caseChosen(int kind, int number);
    /// The solid again, in place of the surface and what is wrong with it.
    void solidWanted();
    void saveRequested();
    /// Only what is looked at is to be fixed.
    void fixRequested();
    /// All of the kind that is looked at are.
    void fixAllRequested();
    /// What that would change is to be seen, as long as the pointer or the keys are on its button.
    void fixOfAllShown(bool shown);
    void repairRequested(int largestHole);
    /// Holes of so many edges are to be filled by it.
    void limitChanged(int largestHole);
    /// The surface as the repair would leave it is to be seen, or as it is.
    void repairShown(bool shown);
    /// A cage around it, or else the exact surface.
    void fitRequested(bool cage);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void arrange();
    void describeControls();
    void connectControls();
    void step(int by);
    void tellCase();
    void offer(QPushButton* button, bool offered);
    QString verdict(bool helps) const;

    QLabel *m_title, *m_text, *m_case, *m_fixText;
    QComboBox* m_kind;
    QToolButton *m_previous, *m_next;
    QPushButton *m_show, *m_save, *m_fix, *m_fixAll, *m_preview, *m_repair, *m_fit;
    OptionField* m_hole;
    Contents m_contents;
    int m_number = 0;
};

}  // namespace wend
