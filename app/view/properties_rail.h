#pragma once

#include <QWidget>
#include <map>

class QAction;
class QToolButton;
class QVBoxLayout;

namespace wend {

class Properties;

/// Where the properties stand at the right of the window. In a narrow window, or when the user wants the room
/// for the shape, a rail with a button for each section is left of them: a click opens them over the view,
/// beside the rail, until one clicks elsewhere or presses Esc.
class PropertiesRail : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kWidth = 44;

    /// `shown` is checked while the properties are to be seen.
    PropertiesRail(Properties& properties, QAction& shown, QWidget* parent);

    /// As wide as a window of that width has room for.
    void fitTo(int windowWidth);
    bool isCollapsed() const { return m_narrow || !m_wanted; }
    /// Over the view.
    bool isOpen() const { return m_open; }
    /// At a section.
    void open(QWidget& section);
    /// At what is wrong with a surface.
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
    bool m_swallows = false;  // the rest of the click that has closed them
};

}  // namespace wend
