#pragma once

#include <optional>

#include "app/session/shape_session.h"

namespace wend {

/// The same document with another energy, or with nothing painted: a second session that goes along with the
/// first, with every change, drag and time. It computes in a thread of its own.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(ShapeSession& session, QObject* parent = nullptr);

    ShapeSession& other() { return m_other; }
    bool isOn() const { return m_on; }
    std::optional<double> phi() const { return m_phi; }
    /// From now on with that energy; with none, as the document without what is painted.
    void begin(std::optional<double> phi);
    /// It rests, with what it has, until it is wanted again.
    void end();
    /// What it shows now is of the same project and time as the first session's; null before.
    FramePtr frame() const;

  signals:
    void changed();

  private:
    void take();
    void takeSelection();
    std::shared_ptr<const Project> wanted() const;

    ShapeSession& m_session;
    ShapeSession m_other;
    int m_generation = -1;  // of the document that it has
    std::optional<double> m_phi;
    bool m_on = false;
};

}  // namespace wend
