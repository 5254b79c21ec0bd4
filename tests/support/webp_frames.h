#pragma once

#include <webp/demux.h>
#include <webp/mux.h>

#include <QByteArray>
#include <QFile>
#include <QImage>
#include <vector>

namespace wend::test {

/// A film as a browser sees it, decoded by libwebp's own player.
struct WebpFrames {
    std::vector<QImage> pictures;
    std::vector<int> ends;  // when each is over, in milliseconds
    int loops = -1;         // 0: for ever
    QByteArray profile;
};

inline WebpFrames webpFrames(const QString& path) {
    QFile file(path);
    WebpFrames frames;
    if (!file.open(QIODevice::ReadOnly)) return frames;
    const QByteArray bytes = file.readAll();
    const WebPData data{reinterpret_cast<const uint8_t*>(bytes.constData()), size_t(bytes.size())};
    WebPAnimDecoderOptions options;
    WebPAnimDecoderOptionsInit(&options);
    options.color_mode = MODE_RGBA;
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, &options);
    WebPAnimInfo info{};
    if (!decoder || !WebPAnimDecoderGetInfo(decoder, &info)) return frames;
    frames.loops = static_cast<int>(info.loop_count);
    while (WebPAnimDecoderHasMoreFrames(decoder)) {
        uint8_t* pixels = nullptr;
        int end = 0;
        if (!WebPAnimDecoderGetNext(decoder, &pixels, &end)) break;
        frames.pictures.push_back(QImage(pixels, int(info.canvas_width), int(info.canvas_height),
                                         int(info.canvas_width) * 4, QImage::Format_RGBA8888)
                                      .copy());
        frames.ends.push_back(end);
    }
    WebPAnimDecoderDelete(decoder);
    WebPMux* mux = WebPMuxCreate(&data, 0);
    WebPData chunk{};
    if (mux && WebPMuxGetChunk(mux, "ICCP", &chunk) == WEBP_MUX_OK)
        frames.profile = QByteArray(reinterpret_cast<const char*>(chunk.bytes), qsizetype(chunk.size));
    WebPMuxDelete(mux);
    return frames;
}

/// Returns the largest visible difference: transparent pixels have no colour.
inline int seenDifference(const QImage& one, const QImage& other) {
    if (one.size() != other.size()) return 256;
    int largest = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x) {
            const QRgb a = one.pixel(x, y), b = other.pixel(x, y);
            largest = std::max(largest, std::abs(qAlpha(a) - qAlpha(b)));
            if (qAlpha(a) == 0 && qAlpha(b) == 0) continue;
            for (const auto& [p, q] :
                 {std::pair{qRed(a), qRed(b)}, {qGreen(a), qGreen(b)}, {qBlue(a), qBlue(b)}})
                largest = std::max(largest, std::abs(p - q));
        }
    return largest;
}

}  // namespace wend::test
