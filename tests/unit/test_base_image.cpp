#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

constexpr float kByteStep = 0.5f / 255.0f;      // half a code value of 8 bits
constexpr float kShortStep = 0.51f / 65535.0f;  // half a code value of 16 bits and float rounding
constexpr float kJpegError = 12.0f / 255.0f;    // quality 90 on flat colours, with chroma ringing

// 64 x 64: left half (200, 90, 30), right half (40, 90, 220).
constexpr std::string_view kJpegBase64 =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wCEAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8XGBYU"
    "GBIUFRQBAwQEBQQFCQUFCRQNCw0UFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFP/AABEIAEAAQAMBIgAC"
    "EQEDEQH/xAGiAAABBQEBAQEBAQAAAAAAAAAAAQIDBAUGBwgJCgsQAAIBAwMCBAMFBQQEAAABfQECAwAEEQUSITFBBhNRYQcicRQygZGhCCNCscEV"
    "UtHwJDNicoIJChYXGBkaJSYnKCkqNDU2Nzg5OkNERUZHSElKU1RVVldYWVpjZGVmZ2hpanN0dXZ3eHl6g4SFhoeIiYqSk5SVlpeYmZqio6Slpqeo"
    "qaqys7S1tre4ubrCw8TFxsfIycrS09TV1tfY2drh4uPk5ebn6Onq8fLz9PX29/j5+gEAAwEBAQEBAQEBAQAAAAAAAAECAwQFBgcICQoLEQACAQIE"
    "BAMEBwUEBAABAncAAQIDEQQFITEGEkFRB2FxEyIygQgUQpGhscEJIzNS8BVictEKFiQ04SXxFxgZGiYnKCkqNTY3ODk6Q0RFRkdISUpTVFVWV1hZ"
    "WmNkZWZnaGlqc3R1dnd4eXqCg4SFhoeIiYqSk5SVlpeYmZqio6Slpqeoqaqys7S1tre4ubrCw8TFxsfIycrS09TV1tfY2dri4+Tl5ufo6ery8/T1"
    "9vf4+fr/2gAMAwEAAhEDEQA/AOfooor+fj+oAooooA85ooor/UU/gAKKKKAPRqKKK/y6P7/CiiigDzmiiiv9RT+AAooooA9Gooor/Lo/v8KKKKAP"
    "OaKKK/1FP4ACiiigD0aiiiv8uj+/wooooA85ooor/UU/gAKKKKAP/9k=";

std::string from_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = (bits << 6) | static_cast<unsigned>(digits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

std::string big_endian(unsigned value, int bytes = 4) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

std::string png_chunk(const std::string& type, const std::string& data) {
    unsigned crc = ~0u;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return big_endian(static_cast<unsigned>(data.size())) + type + data + big_endian(~crc);
}

// One stored deflate block; rows carry their filter byte.
std::string png(unsigned width, unsigned height, int bits, int colour_type, const std::string& rows) {
    unsigned a = 1, b = 0;
    for (const char c : rows) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<unsigned>(rows.size());
    const auto little = [](unsigned v) { return std::string{static_cast<char>(v & 0xff), static_cast<char>(v >> 8)}; };
    const std::string deflated =
        "\x78\x01\x01" + little(size) + little(~size & 0xffff) + rows + big_endian(b << 16 | a);
    const std::string head = big_endian(width) + big_endian(height) + static_cast<char>(bits) +
                             static_cast<char>(colour_type) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", head) + png_chunk("IDAT", deflated) + png_chunk("IEND", "");
}

// Every prefix of a good file is refused, and no byte turned over makes it crash.
void check_damage(const fs::path& file, const std::string& good, std::size_t step) {
    for (std::size_t size = 0; size + 16 < good.size(); size += step) {
        REQUIRE(write_text_atomically(file, good.substr(0, size)));
        const auto image = load_image(file);
        CHECK_MESSAGE(!image, file.string() << " cut to " << size << " of " << good.size());
    }
    for (std::size_t i = 0; i < good.size(); i += step) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 0xff);
        REQUIRE(write_text_atomically(file, bad));
        static_cast<void>(load_image(file, 1'000'000));
    }
}

std::string hdr(int width, int height, const std::string& data) {
    const std::string size = "-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + data;
}

ChannelImage sample_exr() {
    ChannelImage image;
    image.width = 37;
    image.height = 21;
    for (const char* name : {"R", "G", "B", "sky.x"}) {
        std::vector<float>& values = image.channels[name];
        for (int i = 0; i < 37 * 21; ++i) values.push_back(static_cast<float>(i) * 0.37f - 3.0f);
    }
    image.channels["R"][5] = 1e30f;
    image.channels["G"][6] = std::numeric_limits<float>::infinity();
    image.attributes = {{"scene", "kerr\nline 2"}, {"empty", ""}};
    return image;
}

}  // namespace

TEST_CASE("sRGB encoding: fixed points, inverse, clamped") {
    CHECK(srgb_from_linear(0.0f) == 0.0f);
    CHECK(srgb_from_linear(1.0f) == 1.0f);
    CHECK(srgb_from_linear(-1.0f) == 0.0f);
    CHECK(srgb_from_linear(7.0f) == 1.0f);
    CHECK(srgb_from_linear(std::nanf("")) == 0.0f);
    CHECK(srgb_from_linear(0.2140f) == doctest::Approx(0.5).epsilon(1e-3));  // the usual middle grey
    for (float x = 0.0f; x < 1.0f; x += 0.01f) CHECK(linear_from_srgb(srgb_from_linear(x)) == doctest::Approx(x));
}

TEST_CASE("PNG of 8 bits: round trip with and without alpha") {
    const TemporaryFolder folder("png");
    for (const int channels : {3, 4}) {
        Image<unsigned char> image(13, 7, channels);
        for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<unsigned char>(i * 37);
        const fs::path file = folder.path / "a.png";
        REQUIRE(save_png(file, image));
        const auto loaded = load_image(file);
        REQUIRE(loaded);
        CHECK(loaded->width == 13);
        CHECK(loaded->height == 7);
        REQUIRE(loaded->channels == channels);
        for (std::size_t i = 0; i < image.data.size(); ++i) {
            const float code = static_cast<float>(image.data[i]) / 255.0f;
            const bool is_alpha = i % 4 == 3 && channels == 4;
            CHECK((is_alpha ? loaded->data[i] : srgb_from_linear(loaded->data[i])) ==
                  doctest::Approx(code).epsilon(kByteStep));
        }
    }
    CHECK(folder.files() == 1);
    CHECK_FALSE(load_image(folder.path / "a.png", 13 * 7 - 1));
    CHECK(load_image(folder.path / "a.png", 13 * 7));
}

TEST_CASE("PNG of 16 bits keeps its precision, grey becomes three channels") {
    const TemporaryFolder folder("png16");
    std::string rows;
    for (const unsigned y : {0u, 1u}) {
        rows += '\0';
        for (const unsigned x : {0u, 1u, 2u}) rows += big_endian(1000 + 20000 * y + 7 * x, 2);
    }
    REQUIRE(write_text_atomically(folder.path / "a.png", png(3, 2, 16, 0, rows)));
    const auto image = load_image(folder.path / "a.png");
    REQUIRE(image);
    REQUIRE(image->channels == 3);
    for (const int y : {0, 1})
        for (const int x : {0, 1, 2})
            for (const int c : {0, 1, 2}) {
                const float code = static_cast<float>(1000 + 20000 * y + 7 * x) / 65535.0f;
                CHECK(std::fabs(srgb_from_linear(image->at(x, y)[c]) - code) < kShortStep);
            }
}

TEST_CASE("gigantic headers are refused before memory is taken") {
    const TemporaryFolder folder("giant");
    REQUIRE(write_text_atomically(folder.path / "a.png", png(100000, 100000, 8, 2, "x")));
    REQUIRE(write_text_atomically(folder.path / "b.png", png(0x7fffffff, 0x7fffffff, 16, 6, "x")));
    REQUIRE(write_text_atomically(folder.path / "c.hdr", hdr(999999999, 999999999, "x")));
    std::string jpeg = from_base64(kJpegBase64);
    const std::size_t frame = jpeg.find("\xff\xc0");
    REQUIRE(frame != std::string::npos);
    jpeg.replace(frame + 5, 4, "\xff\xff\xff\xff");
    REQUIRE(write_text_atomically(folder.path / "d.jpg", jpeg));
    std::string exr;
    REQUIRE(save_exr(folder.path / "e.exr", sample_exr()));
    exr = *read_text(folder.path / "e.exr");
    const std::size_t window = exr.find("dataWindow") + 11 + 6 + 4;
    exr.replace(window + 8, 8, std::string("\xff\xff\x01\x00\xff\xff\x01\x00", 8));
    REQUIRE(write_text_atomically(folder.path / "e.exr", exr));
    for (const char* name : {"a.png", "b.png", "c.hdr", "d.jpg", "e.exr"}) {
        const auto image = load_image(folder.path / name);
        REQUIRE_FALSE_MESSAGE(image, name);
        CHECK(image.error().kind == ErrorKind::kBadInput);
    }
}

TEST_CASE("what is no image is an error") {
    const TemporaryFolder folder("noimage");
    CHECK_FALSE(load_image(folder.path));
    CHECK_FALSE(load_image(folder.path / "missing.png"));
    CHECK_FALSE(load_image(folder.path / "missing.exr"));
    fs::create_directory(folder.path / "directory.exr");
    CHECK_FALSE(load_image(folder.path / "directory.exr"));
    for (const char* name : {"empty.png", "text.jpg", "text.exr", "gif.png"}) {
        const bool empty = std::string_view(name).starts_with("empty");
        REQUIRE(write_text_atomically(folder.path / name, empty ? "" : "GIF89a, or so it says"));
        CHECK_FALSE(load_image(folder.path / name));
    }
}

TEST_CASE("JPEG is decoded; damaged JPEG and PNG are errors, never crashes") {
    const TemporaryFolder folder("damage");
    const std::string jpeg = from_base64(kJpegBase64);
    REQUIRE(write_text_atomically(folder.path / "a.jpg", jpeg));
    const auto image = load_image(folder.path / "a.jpg");
    REQUIRE(image);
    REQUIRE(image->width == 64);
    constexpr std::array<int, 3> left{200, 90, 30}, right{40, 90, 220};
    for (int c = 0; c < 3; ++c) {
        CHECK(std::fabs(srgb_from_linear(image->at(10, 30)[c]) - static_cast<float>(left[c]) / 255.0f) < kJpegError);
        CHECK(std::fabs(srgb_from_linear(image->at(50, 30)[c]) - static_cast<float>(right[c]) / 255.0f) < kJpegError);
    }
    check_damage(folder.path / "b.jpg", jpeg, 7);

    Image<unsigned char> picture(31, 17, 4);
    for (std::size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = static_cast<unsigned char>(i * i >> 3);
    REQUIRE(save_png(folder.path / "c.png", picture));
    check_damage(folder.path / "d.png", *read_text(folder.path / "c.png"), 23);
}

TEST_CASE("HDR: plain and run-length coded scanlines, cut ones are errors") {
    const TemporaryFolder folder("hdr");
    const fs::path file = folder.path / "a.hdr";
    const std::string plain("\x80\x40\x20\x81\x00\x00\x00\x00", 8);  // (1, 0.5, 0.25) and black
    REQUIRE(write_text_atomically(file, hdr(2, 1, plain)));
    const auto image = load_image(file);
    REQUIRE(image);
    REQUIRE(image->channels == 3);
    CHECK(image->data == std::vector<float>{1.0f, 0.5f, 0.25f, 0.0f, 0.0f, 0.0f});

    const std::string mark("\x02\x02\x00\x08", 4);
    const std::string run8 = mark + "\x88\x80" + "\x88\x40" + "\x04\x20\x20\x20\x20\x84\x20" + "\x88\x82";
    REQUIRE(write_text_atomically(file, hdr(8, 2, run8 + run8)));
    const auto coded = load_image(file);
    REQUIRE(coded);
    CHECK(coded->at(7, 1)[0] == 2.0f);
    CHECK(coded->at(7, 1)[2] == 0.5f);
    for (std::size_t size = 0; size < 2 * run8.size(); ++size) {
        REQUIRE(write_text_atomically(file, hdr(8, 2, (run8 + run8).substr(0, size))));
        CHECK_FALSE(load_image(file));
    }
    check_damage(file, hdr(8, 4, run8 + run8 + run8 + run8), 1);
}

TEST_CASE("EXR: channels and attributes survive, cut and inconsistent ones are errors") {
    const TemporaryFolder folder("exr");
    const ChannelImage image = sample_exr();
    const fs::path file = folder.path / "a.exr";
    REQUIRE(save_exr(file, image));
    const auto loaded = load_exr(file);
    REQUIRE(loaded);
    CHECK(loaded->width == image.width);
    CHECK(loaded->height == image.height);
    CHECK(loaded->channels == image.channels);  // bit for bit
    for (const auto& [name, text] : image.attributes) CHECK(loaded->attributes.at(name) == text);
    const auto colour = load_image(file);
    REQUIRE(colour);
    CHECK(colour->channels == 3);
    CHECK(colour->at(5, 0)[0] == 1e30f);
    check_damage(folder.path / "b.exr", *read_text(file), 61);

    ChannelImage wrong = image;
    wrong.channels["G"].pop_back();
    CHECK_FALSE(save_exr(folder.path / "c.exr", wrong));
    CHECK_FALSE(save_exr(folder.path / "c.exr", ChannelImage{}));
    wrong = image;
    wrong.attributes["channels"] = "a name that OpenEXR needs itself";
    CHECK_FALSE(save_exr(folder.path / "c.exr", wrong));
    CHECK_FALSE(save_exr(folder.path / "missing" / "c.exr", image));
    CHECK_FALSE(fs::exists(folder.path / "c.exr"));
    ChannelImage depth;
    depth.width = depth.height = 1;
    depth.channels["Z"] = {1.0f};
    REQUIRE(save_exr(folder.path / "d.exr", depth));
    CHECK(load_exr(folder.path / "d.exr"));
    CHECK_FALSE(load_image(folder.path / "d.exr"));  // no colours
}

TEST_CASE("a PNG says of itself what it is given to say, and is read as without") {
    const TemporaryFolder folder("saidpng");
    Image<unsigned char> picture(3, 2, 3);
    picture.at(1, 1)[2] = 200;
    REQUIRE(save_png(folder.path / "plain.png", picture));
    REQUIRE(save_png(folder.path / "said.png", picture, {{"Title", "Gebäude"}, {"Software", "nullscope 1"}}));
    const auto plain = load_image(folder.path / "plain.png"), said = load_image(folder.path / "said.png");
    REQUIRE(plain);
    REQUIRE(said);
    CHECK(plain->data == said->data);
    const auto bytes = read_text(folder.path / "said.png");
    REQUIRE(bytes);
    CHECK(bytes->find("iTXtTitle" + std::string(5, '\0') + "Gebäude") != std::string::npos);
    CHECK(bytes->find("iTXtSoftware") != std::string::npos);
}

TEST_CASE("a JPEG that is written is read as it was, to a few code values, and says what it is given to say") {
    const TemporaryFolder folder("jpeg");
    Image<unsigned char> image(64, 40, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width;
             ++x) {  // red and blue change from pixel to pixel: halved colours would mix them
            unsigned char* pixel = image.at(x, y);
            pixel[0] = x % 2 == 0 ? 200 : 60, pixel[1] = static_cast<unsigned char>(4 * y);
            pixel[2] = x % 2 == 0 ? 60 : 200;
        }
    const fs::path file = folder.path / "a.jpg";
    REQUIRE(save_jpeg(file, image, "Gebäude\nnullscope 1"));
    CHECK(folder.files() == 1);
    const auto loaded = load_image(file);
    REQUIRE(loaded);
    REQUIRE(loaded->data.size() == image.data.size());
    float sum = 0.0f;
    for (std::size_t i = 0; i < image.data.size(); ++i)
        sum += std::fabs(srgb_from_linear(loaded->data[i]) - static_cast<float>(image.data[i]) / 255.0f);
    CHECK(sum / static_cast<float>(image.data.size()) < 4.0f / 255.0f);
    const auto bytes = read_text(file);
    REQUIRE(bytes);
    CHECK(bytes->find("Gebäude\nnullscope 1") != std::string::npos);
    CHECK_FALSE(save_jpeg(folder.path / "b.jpg", {}));
    CHECK_FALSE(save_jpeg(folder.path / "b.jpg", Image<unsigned char>(4, 4, 4)));
    CHECK_FALSE(save_jpeg(folder.path / "b.jpg", Image<unsigned char>(65501, 1, 3)));
    CHECK_FALSE(save_jpeg(folder.path / "b.jpg", Image<unsigned char>(4, 4, 3), std::string(70000, 'x')));
    CHECK(folder.files() == 1);
}

TEST_CASE("save_png refuses images that are none") {
    const TemporaryFolder folder("badpng");
    CHECK_FALSE(save_png(folder.path / "a.png", {}));
    CHECK_FALSE(save_png(folder.path / "a.png", Image<unsigned char>(4, 4, 1)));
    Image<unsigned char> cut(4, 4, 3);
    cut.data.pop_back();
    CHECK_FALSE(save_png(folder.path / "a.png", cut));
    CHECK_FALSE(save_png(folder.path / "missing" / "a.png", Image<unsigned char>(4, 4, 3)));
    CHECK(folder.files() == 0);
}

TEST_CASE("hostile pictures are refused before a decoder allocates for them or reads past its tables") {
    const fs::path corpus = test::data_folder() / "fuzz" / "corpus";
    const std::pair<const char*, const char*> cases[] = {
        {"picture/huge-header.png", "10000 x 10000 pixels are not in 69 bytes"},
        {"picture/png-chunk-of-2-gigabytes", nullptr},  // in libpng's words, or libjpeg's
        {"picture/jpeg-huffman-table-cut-off", "the file is too short"},
        {"picture/jpeg-scan-without-its-table", nullptr},
        {"exr/attribute-of-2-gigabytes", "its header is cut off or damaged"},
        {"exr/attribute-sizes-at-odds", "its header is cut off or damaged"},
    };
    for (const auto& [file, says] : cases) {
        const std::string named = file;  // clang 14 captures no structured binding
        CAPTURE(named);
        const auto bytes = read_text(corpus / file);
        REQUIRE(bytes);
        const auto picture = decode_image(*bytes, "x");
        const auto exr = decode_exr(*bytes, "x", 1'000'000'000);
        const std::string said =
            std::string(file).starts_with("exr") ? exr.error().message() : picture.error().message();
        const std::string prefix = "cannot read image 'x': ";
        CHECK_MESSAGE((says != nullptr ? said == prefix + says : said.size() > prefix.size()), said);
    }
    const auto good = read_text(corpus / "picture" / "progressive-444.jpg");
    REQUIRE(good);
    CHECK(decode_image(*good, "x"));
    std::string scans = good->substr(0, good->size() - 2);  // without its end
    const std::size_t scan = scans.find("\xff\xda");
    for (int i = 0; i < 256; ++i) scans += scans.substr(scan, scans.find('\xff', scan + 2) - scan);
    const auto slow = decode_image(scans + "\xff\xd9", "x");
    REQUIRE(!slow);
    CHECK(slow.error().message() == "cannot read image 'x': too many scans");
}
