#pragma once

#include <QObject>

#include "app/project/edits/key_edits.h"
#include "app/project/edits/progress.h"
#include "app/session/shape_session.h"

namespace wend {

/// The bars or keys that are chosen on the tracks, copied keys, and the edits of both, each in one undo step.
/// They are kept by the ids of their pins, so that they stay with these when others come and go; callers name
/// pins by their places in the project as it is now. Edits leave locked pins as they are.
class TrackChoice : public QObject {
    Q_OBJECT

  public:
    explicit TrackChoice(ShapeSession& session, QObject* parent = nullptr);

    const Design& design() const { return m_session.document().design(); }
    std::vector<MotionId> bars() const;
    std::vector<KeyId> keys() const;
    bool isEmpty() const { return m_bars.empty() && m_keys.empty(); }
    bool contains(const MotionId& bar) const { return isAmong(m_bars, {idOf(bar.handle), bar.motion}); }
    bool contains(const KeyId& key) const { return isAmong(m_keys, {idOf(key.handle), key.time}); }
    /// Chooses keys, or bars where there are none.
    void set(const std::vector<MotionId>& bars, const std::vector<KeyId>& keys = {});
    /// Does the same and selects their pins.
    void choose(const std::vector<MotionId>& bars, const std::vector<KeyId>& keys = {});
    void choose(const std::vector<KeyId>& keys) { choose({}, keys); }
    /// Return the chosen bars or keys whose pins are not locked.
    std::vector<MotionId> changeableBars() const { return changeable(bars()); }
    std::vector<KeyId> changeableKeys() const { return changeable(keys()); }
    /// Returns the keys at both ends of bars.
    std::vector<KeyId> endsOf(const std::vector<MotionId>& bars) const;

    /// Changes the design in one undo step and stops the film.
    void change(const QString& what, Design after);
    /// Moves or scales these bars to an interval.
    void moveBars(const std::vector<MotionId>& bars, const MotionTime& span, const QString& what,
                  const QString& mergeKey = {});
    /// Moves the chosen keys in time, as far as possible.
    void moveKeys(double by, const QString& mergeKey = {});
    /// Moves the chosen bars or keys; steps in a row merge.
    void nudge(double by);
    void setEase(Ease ease);
    void setKeyEase(const KeyEase& ease);
    void straighten();
    /// Replaces the chosen bars by few keys; see withFewKeys().
    void simplify(double pixels);
    void remove();
    void holdKeys() { hold(changeableKeys()); }
    void copy();
    bool hasCopies() const { return !m_copied.empty(); }
    /// Sets the copied keys at a time: those of a single pin on the pins that are selected now.
    void paste(double time, bool isMirrored);
    /// Sets the mirror images of the chosen keys at their own times.
    void mirror();

    /// Returns the motions whose easing is edited: the chosen bars, or the motions between the chosen keys.
    std::vector<MotionId> easedMotions() const;
    /// Gives them another progress; steps `by` the same means merge.
    void setProgress(const Progress& progress, const QString& by = {});
    /// Holds the pins during these motions.
    void holdEased();

  signals:
    /// Emitted when other bars or keys are chosen, or the project has changed.
    void changed();

  private:
    template <class One>
    std::vector<One> changeable(std::vector<One> chosen) const {
        std::erase_if(chosen, [this](const One& one) { return !m_session.gestures().mayChange(one.handle); });
        return chosen;
    }
    Id idOf(int handle) const;
    int placeOf(Id pin) const;
    void prune();
    QString stepName(QString what, const std::vector<MotionId>& motions) const;
    void changeKeys(const QString& what, Design after);
    std::vector<CopiedKey> copiesOf(const std::vector<KeyId>& keys) const;
    std::vector<CopiedKey> mirrored(const std::vector<CopiedKey>& copies) const;
    void set(std::vector<CopiedKey> copies, double time, const QString& step);
    void hold(const std::vector<KeyId>& keys);

    ShapeSession& m_session;
    std::vector<std::pair<Id, int>> m_bars;     // pins and numbers of their motions; or
    std::vector<std::pair<Id, double>> m_keys;  // pins and times
    std::vector<std::pair<Id, CopiedKey>> m_copied;
    int m_copiedFrom = -1;  // generation of the document
};

}  // namespace wend
