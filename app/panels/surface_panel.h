#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace wend {

class OptionField;

/// Why a surface bounds no volume: its faults one by one, and possible repairs. Hidden without faults.
class SurfacePanel : public QWidget {
    Q_OBJECT

  public:
    struct Kind {
        QString name;
        int count = 0;
    };
    struct Contents {
        std::vector<Kind> kinds;
        QStringList more;      // faults without a place
        bool isCaged = false;  // the surface is embedded in a cage nonetheless
        int largestHole = 30;
        int kind = 0, number = 0;  // the place to begin with
    };
    explicit SurfacePanel(QWidget* parent = nullptr);
    void showProblems(const Contents& contents);
    /// Reports whether the full repair produces a closed surface, and what it would do.
    void tellOfRepair(bool helps, const QString& repair);
    /// Tells the numbers of edges of the holes that the repair leaves, and offers to fill them, too.
    void tellOfHoles(const std::vector<int>& edges);
    int largestHole() const;
    /// Looks at the place where it is.
    void showPlace() { step(0); }
    /// Shows the fix of the current fault; disabled while it is unknown.
    void showFix(const QString& text, bool mayFix);
    /// Shows the fix of all faults of its kind.
    void showFixOfAll(const QString& text, bool mayFix);
    /// Returns to the solid. Returns false if it was shown already.
    bool leave();

  signals:
    /// Emitted when faults are shown; with a cage, work can continue.
    void faultsShown(bool isCaged);
    /// Emitted to request a view of one fault of a kind.
    void caseChosen(int kind, int number);
    /// Emitted to request the solid in place of the surface and its faults.
    void solidWanted();
    void saveRequested();
    /// Emitted to request a fix of the current fault only.
    void fixRequested();
    /// Emitted to request a fix of all faults of the current kind.
    void fixAllRequested();
    /// Requests a preview of that fix while its button is hovered or focused.
    void fixOfAllShown(bool shown);
    void repairRequested(int largestHole);
    /// Holes of so many edges are to be filled by it.
    void limitChanged(int largestHole);
    /// Requests a preview of the repaired surface, or of the original.
    void repairShown(bool shown);
    /// Emitted to request a cage around it, or else the exact surface.
    void fitRequested(bool cage);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void arrange();
    void makeSteps();
    void makeFixes();
    void makeRepair();
    void step(int by);
    void tellCase();
    void offer(QPushButton* button, bool offered);
    QString verdict(bool helps) const;

    QLabel *m_title, *m_text, *m_case, *m_fixText;
    QComboBox* m_kind;
    QToolButton *m_previous, *m_next;
    QPushButton *m_show, *m_save, *m_fix, *m_fixAll, *m_preview, *m_repair, *m_fit, *m_fillUp;
    OptionField* m_hole;
    Contents m_contents;
    int m_number = 0;
    int m_edges = 0;  // of the largest hole that stays
};

}  // namespace wend
