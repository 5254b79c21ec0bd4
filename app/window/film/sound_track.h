#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <optional>
#include <vector>

#include "app/engine/motion/playback.h"
#include "app/project/edits/document.h"

namespace wend {

/// The sound of the film: its loudness, decoded by the program ffmpeg through a pipe, and the sound itself,
/// which the program ffplay makes while the film plays, or in short pieces while another time is shown by
/// dragging. Without these programs the film is silent.
class SoundTrack : public QObject {
    Q_OBJECT

  public:
    static constexpr double kPeriod = 0.01;  // seconds

    explicit SoundTrack(Document& document, Playback& playback, QObject* parent = nullptr);
    ~SoundTrack() override;

    /// Returns the greatest amplitude, from 0 to 1, of each period; what is decoded so far.
    const std::vector<float>& peaks() const { return m_peaks; }
    bool hasFile() const { return !m_file.isEmpty(); }
    bool isHeard() const { return m_heard; }
    void setHeard(bool heard);
    /// Lets a short piece be heard that begins at a time, after the one that is heard now; of several times
    /// meanwhile, at the last one.
    void scrub(double time);

  signals:
    void changed();

  private:
    void takeProject();
    void decode();
    void read();
    void endDecoding();
    void play();
    void playPiece(double time);
    void endPiece();
    void start(double from, QStringList more);
    void follow(double time);
    void stop();

    Document& m_document;
    Playback& m_playback;
    QProcess m_decoder, m_player;
    QString m_file;  // its path
    std::vector<float> m_peaks;
    QByteArray m_rest;      // samples of a period that is not complete
    QElapsedTimer m_since;  // the player was started
    std::optional<double> m_nextPiece;
    QTimer m_pieceLimit;
    double m_from = 0;
    bool m_heard;
};

}  // namespace wend
