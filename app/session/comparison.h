#pragma once

#include <optional>

#include "app/session/shape_session.h"

namespace wend {

/// A second session of the same document with another energy, or without paint. It follows every change, drag
/// and time of the first and computes in its own thread.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(ShapeSession& session, QObject* parent = nullptr);

    ShapeSession& other() { return m_other; }
    bool isOn() const { return m_on; }
    std::optional<double> phi() const { return m_phi; }
    /// Starts the comparison with that energy, or without paint if none is given.
    void begin(std::optional<double> phi);
    /// Pauses the comparison but keeps its results.
    void end();
    /// Returns the frame for the project and time of the first session; null until it is computed.
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
