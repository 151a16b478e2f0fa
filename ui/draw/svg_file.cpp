#include "ui/draw/picture_file.h"

#include <QString>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>

#include "ui/draw/font_choice.h"
#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"
#include "ui/draw/vector_shapes.h"

namespace asperity {
namespace {

constexpr double kSteps = 100;  // coordinates are kept to a hundredth of a pixel
constexpr double kMillimetresPerPixel = 25.4 / 96;

/// Returns a number of hundredths as a short decimal: "-0.5", "12", "3.07".
std::string hundredths(std::int64_t value) {
  std::string text = value < 0 ? "-" : "";
  const std::int64_t size = value < 0 ? -value : value;
  text += std::to_string(size / 100);
  if (size % 100 == 0) return text;
  text += '.';
  text += static_cast<char>('0' + size % 100 / 10);
  if (size % 10 != 0) text += static_cast<char>('0' + size % 10);
  return text;
}

std::int64_t rounded(float pixels) {
  return std::llround(static_cast<double>(pixels) * kSteps);
}

std::string number(float value) {
  return hundredths(rounded(value));
}

/// Returns three digits, which are enough for opacities.
std::string fraction(float value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                 std::round(static_cast<double>(value) * 1000) / 1000);
  return {buffer.data(), end.ptr};
}

std::string hexColour(const Rgba& c) {
  std::string text = "#";
  for (const float channel : {c.r, c.g, c.b}) {
    const auto byte =
        static_cast<unsigned>(std::lround(255 * std::min(std::max(channel, 0.0F), 1.0F)));
    for (const unsigned digit : {byte / 16, byte % 16}) text += "0123456789abcdef"[digit];
  }
  return text;
}

/// Returns ` fill="#102030" fill-opacity="0.5"`.
std::string paintAttributes(const std::string& what, const std::string& opacity, const Rgba& c) {
  std::string text = " " + what + "=\"" + hexColour(c) + "\"";
  if (c.a < 1) text += " " + opacity + "=\"" + fraction(c.a) + "\"";
  return text;
}

std::string fillAttributes(const Rgba& c) {
  return paintAttributes("fill", "fill-opacity", c);
}

std::string strokeAttributes(const Rgba& c) {
  return paintAttributes("stroke", "stroke-opacity", c);
}

std::string stopAttributes(const Rgba& c) {
  return paintAttributes("stop-color", "stop-opacity", c);
}

/// The first point is absolute, others are relative to the previous one; differences of rounded
/// points do not accumulate errors.
void appendPath(std::string& path, const Polyline& line, bool closed) {
  std::int64_t x = rounded(line[0].x), y = rounded(line[0].y);
  path += "M" + hundredths(x) + " " + hundredths(y);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const std::int64_t toX = rounded(line[i].x), toY = rounded(line[i].y);
    const std::string dx = hundredths(toX - x), dy = hundredths(toY - y);
    // A minus sign separates two numbers as well as a blank does.
    path += i == 1 ? "l" : dx[0] == '-' ? "" : " ";
    path += dx + (dy[0] == '-' ? "" : " ") + dy;
    x = toX;
    y = toY;
  }
  if (line.size() == 1) path += "h0";  // a dot, because ends are round
  if (closed) path += "z";
}

class SvgWriter {
 public:
  SvgWriter(const DrawList& list, const PictureProperties& properties)
      : list_(list), properties_(properties) {}

  std::string write() {
    for (const DrawLayer& layer : list_.layers) {
      addFields(layer);
      addLayer(vectorized(layer));
    }
    addTexts();
    const std::string width = std::to_string(list_.width), height = std::to_string(list_.height);
    std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    const auto side = [&](int pixels) {
      if (!properties_.isOnPaper) return std::to_string(pixels);
      char text[32];
      const auto end = std::to_chars(text, text + sizeof text,
                                     pixels * (kMillimetresPerPixel / properties_.scale),
                                     std::chars_format::general, 6);
      return std::string(text, end.ptr) + "mm";
    };
    svg += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + side(list_.width) +
           "\" height=\"" + side(list_.height) + "\" viewBox=\"0 0 " + width + " " + height +
           "\">\n";
    if (!properties_.title.empty()) svg += "<title>" + xmlText(properties_.title) + "</title>\n";
    if (!properties_.metadata.empty())
      svg += "<metadata>" + xmlText(properties_.metadata) + "</metadata>\n";
    if (!list_.texts.empty()) svg += style();
    if (!definitions_.empty()) svg += "<defs>\n" + definitions_ + "</defs>\n";
    svg += "<rect width=\"" + width + "\" height=\"" + height + "\"" +
           fillAttributes(list_.background) + "/>\n";
    return svg + body_ + "</svg>\n";
  }

 private:
  void addLayer(const VectorLayer& layer) {
    if (layer.fills.empty() && layer.strokes.empty()) return;
    body_ += "<g" + clipAttribute(layer.clip) + ">\n";
    for (const VectorFill& fill : layer.fills) addFill(fill);
    if (!layer.strokes.empty()) {
      body_ += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
      for (const VectorStroke& stroke : layer.strokes) addStroke(stroke);
      body_ += "</g>\n";
    }
    body_ += "</g>\n";
  }

  /// A mesh of many colours would be large, and viewers would show its seams.
  void addFields(const DrawLayer& layer) {
    constexpr int kMaxPixels = 320;
    for (const DrawField& field : layer.fields) {
      const QImage image = fieldImage(field, kMaxPixels);
      if (image.isNull()) continue;
      const std::string bytes = encodePng(image);
      const Box box = boundingBox(field);
      body_ +=
          "<g" + clipAttribute(layer.clip) + "><image x=\"" + number(box.x) + "\" y=\"" +
          number(box.y) + "\" width=\"" + number(box.width) + "\" height=\"" + number(box.height) +
          "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
          QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())).toBase64().toStdString() +
          "\"/></g>\n";
    }
  }

  std::string clipAttribute(const Box& clip) {
    if (clip.width == 0) return {};
    const std::string rectangle = "<rect x=\"" + number(clip.x) + "\" y=\"" + number(clip.y) +
                                  "\" width=\"" + number(clip.width) + "\" height=\"" +
                                  number(clip.height) + "\"/>";
    const auto [known, isNew] = clips_.emplace(rectangle, "c" + std::to_string(clips_.size()));
    if (isNew)
      definitions_ += "<clipPath id=\"" + known->second + "\">" + rectangle + "</clipPath>\n";
    return " clip-path=\"url(#" + known->second + ")\"";
  }

  void addFill(const VectorFill& fill) {
    std::string path;
    for (const Polyline& outline : fill.outlines) appendPath(path, outline, true);
    body_ += "<path d=\"" + path + "\"" + fillWith(fill.paint) +
             (fill.isPieceOfMesh ? " shape-rendering=\"crispEdges\"" : "") + "/>\n";
  }

  std::string fillWith(const VectorPaint& paint) {
    if (!paint.isGradient) return fillAttributes(paint.from);
    const std::string name = "g" + std::to_string(gradients_++);
    definitions_ += "<linearGradient id=\"" + name + "\" gradientUnits=\"userSpaceOnUse\" x1=\"" +
                    number(paint.start.x) + "\" y1=\"" + number(paint.start.y) + "\" x2=\"" +
                    number(paint.end.x) + "\" y2=\"" + number(paint.end.y) + "\"><stop" +
                    stopAttributes(paint.from) + "/><stop offset=\"1\"" + stopAttributes(paint.to) +
                    "/></linearGradient>\n";
    return " fill=\"url(#" + name + ")\"";
  }

  void addStroke(const VectorStroke& stroke) {
    std::string path;
    for (const Polyline& line : stroke.lines) appendPath(path, line, false);
    body_ += "<path d=\"" + path + "\"" + strokeAttributes(stroke.colour) + " stroke-width=\"" +
             number(stroke.width) + "\"/>\n";
  }

  void addTexts() {
    if (list_.texts.empty()) return;
    body_ += "<g xml:space=\"preserve\">\n";
    for (const DrawText& text : list_.texts) body_ += textElement(text);
    body_ += "</g>\n";
  }

  static std::string textElement(const DrawText& text) {
    std::string element = "<text";
    if (text.angle == 0)
      element += " x=\"" + number(text.x) + "\" y=\"" + number(text.y) + "\"";
    else
      element += " transform=\"translate(" + number(text.x) + " " + number(text.y) + ") rotate(" +
                 number(-text.angle * 57.2957795F) + ")\"";
    element += " font-size=\"" + std::to_string(std::max(1L, std::lround(text.size))) + "\"";
    if (text.bold) element += " font-weight=\"bold\"";
    if (text.anchor != TextAnchor::Left)
      element +=
          text.anchor == TextAnchor::Centre ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
    return element + fillAttributes(text.colour) + ">" + xmlText(text.utf8) + "</text>\n";
  }

  /// Letters keep their measured distances: without kerning and ligatures.
  std::string style() const {
    std::string css;
    const FontChoice& choice = fontChoice();
    const auto add = [&](const std::string& family, bool bold, const QByteArray& font) {
      css += "@font-face{font-family:\"" + family +
             "\";font-weight:" + std::string(bold ? "bold" : "normal") +
             ";src:url(data:font/ttf;base64," + font.toBase64().toStdString() + ")}\n";
    };
    for (const bool bold : {false, true}) {
      std::set<char32_t> characters = charactersIn(list_, bold), chosen;
      for (const char32_t character : characters)
        if (choice.face(bold).advances.contains(character)) chosen.insert(character);
      for (const char32_t character : chosen) characters.erase(character);
      if (!chosen.empty()) add(xmlText(choice.family), bold, chosenFontSubset(bold, chosen));
      if (!characters.empty()) add("DejaVu Sans", bold, fontSubset(bold, characters));
    }
    const std::string first = choice.family.empty() ? "" : "\"" + xmlText(choice.family) + "\",";
    return "<style>\n" + css + "text{font-family:" + first +
           "\"DejaVu Sans\",sans-serif;font-kerning:none;"
           "font-variant-ligatures:none;white-space:pre}\n</style>\n";
  }

  const DrawList& list_;
  const PictureProperties& properties_;
  std::string definitions_, body_;
  std::map<std::string, std::string> clips_;  // rectangle -> name
  int gradients_ = 0;
};

}  // namespace

std::string svgText(const DrawList& list, const PictureProperties& properties) {
  return SvgWriter(list, properties).write();
}

namespace {

bool isXmlCharacter(char32_t c) {
  return c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
}

}  // namespace

std::string xmlText(std::string_view utf8) {
  // Qt replaces bytes that are not UTF-8.
  const auto characters =
      QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())).toUcs4();
  QString text;
  for (const char32_t character : characters) {
    const char32_t held = isXmlCharacter(character) ? character : U'\uFFFD';
    text += QString::fromUcs4(&held, 1);
  }
  return text.toHtmlEscaped().toStdString();
}

std::string xmpPacket(const std::string& title, const std::string& description) {
  std::string packet =
      "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
      "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description rdf:about=\"\" "
      "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n";
  const auto add = [&](const std::string& name, const std::string& text) {
    if (text.empty()) return;
    packet += "<dc:" + name + "><rdf:Alt><rdf:li xml:lang=\"x-default\">" + xmlText(text) +
              "</rdf:li></rdf:Alt></dc:" + name + ">\n";
  };
  add("title", title);
  add("description", description);
  return packet + "</rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end=\"w\"?>";
}

}  // namespace asperity
