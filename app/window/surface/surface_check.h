#pragma once

#include <QObject>
#include <memory>

#include "app/base/latest.h"
#include "app/views/volume/volume_view.h"
#include "core/meshing/surface_faults.h"
#include "core/meshing/surface_fixes.h"

namespace wend {

class Document;
class Playback;
class ShapeMotion;
class SolidCanvas;
class SurfacePanel;

/// Shows a surface while it is meshed. If that fails, or needs a cage, checks it in the background, shows its
/// faults and executes the panel's commands.
class SurfaceCheck : public QObject {
    Q_OBJECT

  public:
    SurfaceCheck(Document& document, const Playback& playback, const ShapeMotion& motion, SurfacePanel& panel,
                 QWidget& window);
    void setCanvas(SolidCanvas* canvas) { m_canvas = canvas; }
    void hide();
    /// Returns to the solid when a tool is activated.
    void leave();

  private:
    struct Repaired {
        explicit Repaired(const Surface& whole, int largestHole)
            : surface(repairSurface(whole, largestHole, report)), left(checkSurface(surface)) {}
        RepairReport report;  // effect of the repair
        Surface surface;
        SurfaceProblems left;
    };
    struct Found {
        Surface source;                 // as the file has it
        std::vector<SurfaceFix> fixes;  // of single faults that were fixed …
        Surface surface;                // … and the surface after them
        std::vector<int> numbers;       // of its triangles, in the file
        SurfaceProblems problems;
        std::vector<FaultKind> faults;
        std::shared_ptr<const Repaired> repaired;  // the repaired surface
    };
    struct Place {
        int kind = 0, number = 0;
        bool operator==(const Place&) const = default;
    };
    /// The fix of all faults of a kind.
    struct All {
        std::shared_ptr<const Found> found;
        int kind = 0, limit = 0;                   // edges of the largest hole, if the user has chosen that
        std::shared_ptr<const FaultFix> fix = {};  // once that is known
        bool isSought = false, isWanted = false;
    };
    void preview();
    void look();
    void take(const std::shared_ptr<const Found>& found);
    Place placeToBeginWith() const;
    void takeShape();
    void keepPlace();
    void showSurface();
    VolumePicture picture(const std::vector<bool>& kept, const std::vector<int>& chosen,
                          const FaultFix* fix) const;
    VolumePicture picture(const FaultFix* fix) const;
    Vec3 directionToWrong() const;
    void showCase(int kind, int number);
    void showPlace(bool fromNear);
    void propose();
    void proposeAll();
    QString textOf(const FaultFix& fix) const;
    void tellOfFix();
    void fix(const std::shared_ptr<const FaultFix>& fix, const QString& name);
    void fixAll();
    void showFixOfAll(bool shown);
    void showSolid();
    void showCaged();
    void fitCage(bool cage);
    void saveList();
    void repair(int largestHole);
    void tryLimit(int largestHole);
    void tellOfRepair();
    void showRepair(bool shown);
    QString repairText() const;
    static std::vector<int> holesIn(const SurfaceProblems& problems);
    static QString wouldDo(const std::vector<std::pair<QString, int>>& repairs);

    Document& m_document;
    const Playback& m_playback;
    const ShapeMotion& m_motion;
    SurfacePanel& m_panel;
    QWidget& m_window;
    SolidCanvas* m_canvas = nullptr;
    std::shared_ptr<const Found> m_found;
    std::shared_ptr<const Repaired> m_repaired;  // with the limit that the panel has
    Place m_place;                               // in m_found
    bool m_isPlaceShown = false, m_isFixOfAllShown = false;
    std::shared_ptr<const FaultFix> m_fix;  // the fix of this fault, once it is known
    All m_all;
    bool m_goesOn = false;                // one was fixed: the next one is looked at …
    std::string m_fixedKind;              // … of this kind
    std::shared_ptr<const void> m_shape;  // the last one that was shown
    bool m_isCaged = false;               // it is embedded in a cage
    Latest m_reading{this}, m_checking{this};
};

}  // namespace wend
