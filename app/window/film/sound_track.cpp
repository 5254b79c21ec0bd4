#include "app/window/film/sound_track.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/project/edits/film_edits.h"
#include "core/base/fed_process.h"

namespace wend {

namespace {

constexpr int kLoudnessRate = 8000;  // samples per second of the loudness
constexpr int kPeriodSamples = static_cast<int>(kLoudnessRate * SoundTrack::kPeriod);
constexpr double kMostDrift = 0.25;  // seconds between sound and picture
constexpr double kPiece = 0.12;      // seconds of sound while scrubbing
constexpr int kPieceLimit = 2000;    // milliseconds after which a player that hangs is ended

/// Returns the file with ffmpeg's prefix for files, so that no name is taken for a URL or an option.
QString fileWord(const QString& path) {
    return QStringLiteral("file:") + path;
}

QString programNamed(const char* name) {
    return QString::fromStdString(programInPath(name));
}

/// Kills the process and waits until it has ended.
void endProcess(QProcess& process) {
    if (process.state() == QProcess::NotRunning) return;
    const QSignalBlocker quiet(&process);
    process.kill();
    process.waitForFinished();
}

}  // namespace

SoundTrack::SoundTrack(Document& document, Playback& playback, QObject* parent)
    : QObject(parent), m_document(document), m_playback(playback), m_heard(preferences::soundHeard.value()) {
    m_decoder.setStandardInputFile(QProcess::nullDevice());
    m_player.setStandardInputFile(QProcess::nullDevice());
    m_player.setStandardOutputFile(QProcess::nullDevice());
    m_player.setStandardErrorFile(QProcess::nullDevice());
    connect(&m_decoder, &QProcess::readyReadStandardOutput, this, &SoundTrack::read);
    connect(&m_decoder, &QProcess::finished, this, &SoundTrack::endDecoding);
    connect(&m_player, &QProcess::finished, this, &SoundTrack::endPiece);
    m_pieceLimit.setSingleShot(true);
    m_pieceLimit.callOnTimeout(&m_player, &QProcess::kill);
    connectEach(this, &SoundTrack::takeProject, &document, &Document::projectChanged, &document,
                &Document::opened);
    connect(&playback, &Playback::playingChanged, this, [this](bool plays) { plays ? play() : stop(); });
    connect(&playback, &Playback::timeChanged, this, &SoundTrack::follow);
    takeProject();
}

SoundTrack::~SoundTrack() {
    endProcess(m_decoder);
    endProcess(m_player);
}

void SoundTrack::setHeard(bool heard) {
    m_heard = heard;
    preferences::soundHeard.set(heard);
    heard&& m_playback.isPlaying() ? play() : stop();
}

void SoundTrack::takeProject() {
    const QString name = QString::fromStdString(filmMarksOf(m_document).audio);
    const QString file = name.isEmpty() ? QString() : QDir(m_document.folder()).absoluteFilePath(name);
    if (file == m_file) return;
    m_file = file;
    stop();
    endProcess(m_decoder);
    m_peaks.clear();
    m_rest.clear();
    if (hasFile()) decode();
    emit changed();
}

void SoundTrack::decode() {
    const QString program = programNamed("ffmpeg");
    if (program.isEmpty()) {
        m_document.notify(
            tr("The sound is not shown: that needs the program ffmpeg (Debian: sudo apt "
               "install ffmpeg)."));
        return;
    }
    m_decoder.start(program, {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-nostdin"),
                              QStringLiteral("-i"), fileWord(m_file), QStringLiteral("-map"),
                              QStringLiteral("0:a:0"), QStringLiteral("-ac"), QStringLiteral("1"),
                              QStringLiteral("-ar"), QString::number(kLoudnessRate), QStringLiteral("-f"),
                              QStringLiteral("s16le"), QStringLiteral("pipe:1")});
}

void SoundTrack::read() {
    m_rest += m_decoder.readAllStandardOutput();
    constexpr int kBytes = 2 * kPeriodSamples;
    const qsizetype periods = m_rest.size() / kBytes;
    for (qsizetype i = 0; i < periods; ++i) {
        int loudest = 0;
        for (int k = 0; k < kPeriodSamples; ++k) {
            std::int16_t sample = 0;
            std::memcpy(&sample, m_rest.constData() + i * kBytes + 2 * k, sizeof sample);
            loudest = std::max(loudest, std::abs(int{sample}));
        }
        m_peaks.push_back(static_cast<float>(loudest) / 32768);
    }
    m_rest.remove(0, periods * kBytes);
    if (periods > 0) emit changed();
}

void SoundTrack::endDecoding() {
    read();
    if (m_decoder.exitCode() == 0 && m_decoder.exitStatus() == QProcess::NormalExit) return;
    m_document.notify(
        tr("The sound %1 cannot be read: is the file there?").arg(QFileInfo(m_file).fileName()));
}

void SoundTrack::play() {
    stop();
    if (!m_heard || !hasFile()) return;
    m_from = m_playback.time();
    QStringList more;
    if (const double speed = m_playback.speed(); speed != 1)  // a filter halves at most
        more << QStringLiteral("-af")
             << (speed < 0.5 ? QStringLiteral("atempo=0.5,atempo=%1").arg(2 * speed)
                             : QStringLiteral("atempo=%1").arg(speed));
    start(m_from, more);
    m_since.start();
}

void SoundTrack::start(double from, QStringList more) {
    const QString program = programNamed("ffplay");
    if (program.isEmpty()) return;
    const QStringList words = {
        QStringLiteral("-nodisp"),     QStringLiteral("-autoexit"), QStringLiteral("-v"),
        QStringLiteral("quiet"),       QStringLiteral("-vn"),       QStringLiteral("-ss"),
        QString::number(from, 'f', 3), QStringLiteral("-i"),        fileWord(m_file)};
    m_player.start(program, words + more);
}

void SoundTrack::scrub(double time) {
    if (!m_heard || !hasFile() || m_playback.isPlaying()) return;
    if (m_player.state() == QProcess::NotRunning)
        playPiece(time);
    else
        m_nextPiece = time;
}

void SoundTrack::playPiece(double time) {
    m_nextPiece.reset();
    start(time, {QStringLiteral("-t"), QString::number(kPiece)});
    m_pieceLimit.start(kPieceLimit);
}

void SoundTrack::endPiece() {
    m_pieceLimit.stop();
    if (const auto next = std::exchange(m_nextPiece, std::nullopt)) playPiece(*next);
}

/// After a loop or a pause of the computation, the sound begins anew.
void SoundTrack::follow(double time) {
    if (!m_heard || !hasFile() || !m_playback.isPlaying() || !m_since.isValid()) return;
    const double heard = m_from + 1e-3 * static_cast<double>(m_since.elapsed()) * m_playback.speed();
    if (std::abs(time - heard) > kMostDrift) play();
}

void SoundTrack::stop() {
    m_nextPiece.reset();
    m_pieceLimit.stop();
    endProcess(m_player);
    m_since.invalidate();
}

}  // namespace wend
