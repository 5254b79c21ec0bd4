#pragma once

#include <QWidget>
#include <map>

class QAction;
class QToolButton;
class QVBoxLayout;

namespace wend {

class Properties;

/// The area of the side panel. In a narrow window, or if the user hides the panels, it is a rail with a
/// button per section: a click opens the panels over the view until a click elsewhere or Esc.
class PropertiesRail : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kWidth = 44;

    /// `shown` is checked while the panels are to be visible.
    PropertiesRail(Properties& properties, QAction& shown, QWidget* parent);

    /// Adapts to the width of the window.
    void fitTo(int windowWidth);
    bool isCollapsed() const { return m_narrow || !m_wanted; }
    /// Returns whether the panels are open over the view.
    bool isOpen() const { return m_open; }
    /// Opens the panels at a section.
    void open(QWidget& section);
    /// Opens the panels at the surface's faults.
    void openAtSurface();
    void close();

  signals:
    /// The keyboard is for the view again.
    void done();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void take(bool shown);
    void toggle(QWidget& section);
    void arrange();
    void place();
    void showSections();
    QToolButton* buttonOf(QWidget& section);
    bool isBeside(const QWidget& widget) const;
    bool closesBy(const QWidget& widget, const QEvent& press);

    Properties& m_properties;
    QAction& m_shown;
    QVBoxLayout* m_column;
    std::map<QWidget*, QToolButton*> m_buttons;
    QWidget* m_section = nullptr;  // that is open
    bool m_narrow = false, m_wanted = true, m_open = false;
    bool m_swallows = false;  // ignores the rest of the click that closed the panels
};

}  // namespace wend
