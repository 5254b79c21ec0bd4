#pragma once

#include <QLabel>
#include <QTimer>
#include <array>
#include <functional>

class QAction;

namespace wend {

class EnergySlider;
class ShapeCanvas;
class ShapeSession;
class SolidCanvas;
class Toolbox;

/// What to do first, said beside where it is done, to who uses Wend for the first time: one thing after the
/// other, and each goes for good once it is done. The pointer goes through it.
class FirstTips : public QLabel {
    Q_OBJECT

  public:
    struct Parts {
        ShapeSession& session;
        const Toolbox& tools;
        ShapeCanvas& picture;
        std::function<SolidCanvas*()> solid;  // null before the first one
        const EnergySlider& energies;
        const QWidget& tutorial;  // which says more: meanwhile there are no tips
        QAction& wanted;          // by the user; off once all is done
    };
    enum Tip { Pin, Drag, Keep };
    static constexpr int kTips = 3;

    FirstTips(const Parts& parts, QWidget& over);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    bool isDone(Tip tip) const { return m_done & 1 << tip; }
    void setDone(int tips);
    void takeProject();
    void begin();
    bool mayShow() const;
    int due() const;
    bool isBesideKeep() const;
    QPointF anchor(Tip tip) const;
    template <int Dim, class Canvas>
    QPointF anchorOn(const Canvas& canvas, Tip tip) const;
    void follow();

    Parts m_parts;
    QTimer m_timer;                        // what it points at moves with the view
    int m_done = 0;                        // a bit for each tip
    std::array<double, kTips> m_before{};  // what each changes, as it was
    bool m_pointsLeft = true;              // else to the right
};

}  // namespace wend
