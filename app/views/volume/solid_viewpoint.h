#pragma once

#include <optional>

#include "app/project/edits/document.h"
#include "app/views/volume/volume_view.h"

namespace wend {

/// The camera of a view and of its document. It fits the view to a new solid, and again whenever its size
/// changes, until the user moves it; the document keeps it.
class SolidViewpoint {
  public:
    SolidViewpoint(VolumeView& view, Document& document) : m_view(view), m_document(document) {}

    /// Returns true once per document, and looks at its solid as at first then.
    bool begin();
    /// Looks as at documents without a camera.
    void lookAtFirst();
    /// Restores the document's camera after fitting, which sets the depth range.
    void restore();
    /// Takes the axis of the document that points up.
    void takeUpAxis();
    /// Keeps the camera in the document, unless the user has not moved it.
    void keep();
    /// Turns the view.
    void lookAlong(const Vec<3>& direction);
    /// Shows these points as large as they fit.
    void zoomTo(const Points<3>& points);

    bool isFitted() const { return m_isFitted; }
    /// The view follows its size no more.
    void setFitted(bool fitted) { m_isFitted = fitted; }

  private:
    bool isOfDocument() const { return m_document.generation() == m_generation; }

    VolumeView& m_view;
    Document& m_document;
    std::optional<SavedCamera> m_asOpened;  // the camera of the opened document in stored form
    int m_generation = -1;                  // of the document that the view was fitted to
    bool m_isFitted = false;
};

}  // namespace wend
