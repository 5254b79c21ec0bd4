#pragma once

#include <QAction>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "app/project/pin.h"
#include "app/session/part_making.h"
#include "app/window/notices/info_banner.h"
#include "warp/alpha_outline_options.h"
#include "warp/image.h"

namespace wend {

class Document;
class Playback;
class ShapeSession;

/// Returns whether the upper and lower edges are opaque.
bool hasOpaqueEdges(const Image& picture);
/// Returns whether the outline cuts off a wide soft edge, a glow or a shadow.
bool cutsSoftEdges(const Image& picture, const AlphaOutlineOptions& outline);
/// Returns whether most of what the outline encloses is empty: thin strokes around areas without fill.
bool isLineArt(const Image& picture, const AlphaOutlineOptions& outline);

/// Offers to hold the border of a photograph, to include soft edges, to fill the holes of line art, to draw
/// an SVG drawing in another size, or to open layers as one picture when a file was opened. An offer is shown
/// until it is accepted, declined or irrelevant. Nothing is offered for saved projects.
class Offers : public QObject {
    Q_OBJECT

  public:
    /// `size`: asks for the size of a drawing.
    Offers(Document& document, InfoBanner& banner, QAction& size, QObject* parent);

  private:
    struct Words {
        QString text;
        QList<InfoBanner::Remedy> remedies;
    };
    struct Offer {
        InfoBanner::Topic topic;
        /// Whether it matters for the document as it is.
        std::function<bool()> matters;
        /// Whether the picture calls for it; asked in the background. None: whenever it matters.
        std::function<bool(const Image&, const AlphaOutlineOptions&)> isCalledFor;
        std::function<Words()> words;
    };

    Offer border();
    Offer softEdges();
    Offer lineArt();
    Offer parts();
    Offer drawing();
    InfoBanner::Remedy sizeButton();
    void look();
    void follow();
    void make(const Offer& offer);
    /// Returns whether the outline of the document's picture is made of its alpha.
    bool isCutOut() const;

    Document& m_document;
    InfoBanner& m_banner;
    QAction& m_size;
    const std::vector<Offer> m_all;
    bool m_isDrawing = false;            // what was opened
    std::set<InfoBanner::Topic> m_made;  // and neither taken nor withdrawn
};

/// Tells of parts and islands of a picture that no pin holds once the rest has been moved, and offers to let
/// them follow what is beside them. It is shown once for each number of such parts.
class RidingOffer : public QObject {
    Q_OBJECT

  public:
    RidingOffer(ShapeSession& session, InfoBanner& banner, QObject* parent);

  private:
    void look();
    void offer(const std::vector<StrayPart>& strays);

    ShapeSession& m_session;
    InfoBanner& m_banner;
    std::shared_ptr<const Project> m_lookedAt;
    std::size_t m_offered = 0;
};

/// Returns whether a handle that has moved ends where it began.
bool comesBack(const Pin& handle);

/// Offers to let the shape spring back fully where it does not spring back at all, and a handle ends where it
/// began or the film loops: the shape would end elsewhere.
class SpringOffer : public QObject {
    Q_OBJECT

  public:
    SpringOffer(Document& document, const Playback& playback, InfoBanner& banner, QObject* parent);

  private:
    bool isDue() const;
    void follow();

    Document& m_document;
    const Playback& m_playback;
    InfoBanner& m_banner;
    bool m_isOffered = false, m_isDeclined = false;
};

/// Returns buttons for a project that cannot be computed: where memory is short, a solver that needs less and
/// half as many vertices, as far as the project allows; and Undo if there is a step.
QList<InfoBanner::Remedy> problemRemedies(Document& document, bool lacksMemory);

/// Messages about a new shape, once per mesh.
class ShapeNotices : public QObject {
    Q_OBJECT

  public:
    ShapeNotices(ShapeSession& session, InfoBanner& banner, QObject* parent);

  signals:
    /// Emitted to request the reason for a cage.
    void reasonWanted();

  private:
    void follow();
    template <int Dim>
    void tell();
    template <int Dim>
    QString hangingText() const;
    template <int Dim>
    void pinHanging();

    ShapeSession& m_session;
    InfoBanner& m_banner;
    std::shared_ptr<const void> m_shape;  // the rest mesh that was reported
    bool m_hasShown = false;              // and there was something to say
};

}  // namespace wend
