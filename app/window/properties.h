#pragma once

#include <QWidget>
#include <map>
#include <vector>

#include "app/session/brush.h"
#include "app/tools/mode.h"

class QAction;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace wend {

class Actions;
class CutOutPanel;
class CutPanel;
class DistortionPanel;
class Exporter;
class FactsPanel;
class FoldingSection;
class GroupList;
class LayerPanel;
class MaterialPanel;
class MeasurePanel;
class MeshPanel;
class PaintPanel;
class PartList;
class PinList;
class ReachRow;
class RegionList;
class ShapeSession;
class SurfacePanel;
class Toolbox;

/// The panels on the right: the energy on top, always visible; below it those of the step and of the
/// selection, and the advanced numbers, folded at first. Nothing jumps when the selection changes: its height
/// is reserved.
class Properties : public QWidget {
    Q_OBJECT

  public:
    Properties(ShapeSession& session, Exporter& exporter, const Toolbox& tools, const Actions& actions);

    MaterialPanel& material() { return *m_material; }
    MeshPanel& mesh() { return *m_mesh; }
    DistortionPanel& distortion() { return *m_distortion; }
    FactsPanel& facts() { return *m_facts; }
    CutPanel& cut() { return *m_cut; }
    MeasurePanel& measure() { return *m_measure; }
    Brush& brush() { return m_brush; }
    LayerPanel& layers() { return *m_layers; }
    RegionList& detailRegions() { return *m_detailRegions; }
    GroupList& groups() { return *m_groups; }
    RegionList& depthRegions() { return *m_depthRegions; }
    SurfacePanel& surface() { return *m_surface; }
    PartList& parts() { return *m_parts; }
    PinList& pins() { return *m_pins; }

    /// Sets the width for a window's width. In wide windows the pins get a column of their own.
    void fitTo(int windowWidth);
    /// A section of the side panel, with the name that the rail shows.
    struct Section {
        QString name;
        const char* icon;
        QWidget* place;
    };
    /// Returns the sections of this step from the top.
    std::vector<Section> sections() const;
    /// Brings a section into view.
    void showSection(QWidget& section);
    /// Shows the cut's panel in the first step while the action is on.
    void showCutWhile(const QAction& on);

  signals:
    void sectionsChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// The condition under which a panel is shown.
    struct When {
        Modes modes;
        bool flat = true, solid = true;
        const char* tool = nullptr;     // only while that is chosen, …
        const char* without = nullptr;  // … or while that is not
        const QAction* on = nullptr;    // in other steps, too, while that is so
        bool fills = false;             // takes the room that is left
    };
    struct Place {
        QWidget *holder, *panel;
        QString name;
        const char* icon;
        When when;
    };
    void put(QWidget* panel, const QString& name, const char* icon, const When& when);
    Place& place(const QWidget& panel);
    bool isDue(const When& when) const;
    QWidget* selectionArea(ShapeSession& session);
    void fill(ShapeSession& session, Exporter& exporter, const Actions& actions);
    void arrange();
    void putPinsBeside(bool beside);

    const Toolbox& m_tools;
    Mode m_mode = Mode::Pins;  // the current step
    MaterialPanel* m_material;
    ReachRow* m_reach;
    MeshPanel* m_mesh;
    CutOutPanel* m_cutOut;
    DistortionPanel* m_distortion;
    CutPanel* m_cut;
    MeasurePanel* m_measure;
    Brush m_brush;
    PaintPanel* m_paint;
    LayerPanel* m_layers;
    FactsPanel* m_facts;
    RegionList *m_detailRegions, *m_depthRegions;
    GroupList* m_groups;
    SurfacePanel* m_surface;
    PartList* m_parts;
    PinList* m_pins;
    FoldingSection* m_advanced;
    QWidget *m_content, *m_beside;  // the scrolled column, and the pins in a wide window
    QVBoxLayout* m_column;
    QScrollArea* m_scroll;
    std::vector<Place> m_places;
};

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
    /// Emitted to return the keyboard to the view.
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
