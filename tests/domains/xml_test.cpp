// What an SVG is before it is a drawing: XML with entities and namespaces, perhaps packed.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <zlib.h>

#include <string>
#include <string_view>
#include <vector>

#include "domains/xml_entities.h"
#include "files/gzip.h"
#include "refusal.h"

namespace xml_test {

using namespace lacuna;

const std::string kPath = "<path d='M0 0h1v2z'/>";
const std::string kSpace = " xmlns='http://www.w3.org/2000/svg'";

std::size_t rings_in(const std::string& bytes) {
    return decode_polygons(bytes, "svg", "file").rings.size();
}

std::string with_dtd(const std::string& subset, const std::string& elements) {
    return "<?xml version='1.0'?>\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
           "\"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\" [" +
           subset + "]>\n<svg viewBox='0 0 8 10'" + kSpace + ">" + elements + "</svg>";
}

TEST(Entities, AreReplacedInTextsAndInAttributes) {
    const auto replaced = [](const std::string& subset, const std::string& text) {
        return domains::with_entities("<!DOCTYPE a [" + subset + "]>" + text, "file");
    };
    EXPECT_EQ(replaced("<!ENTITY a \"x\"><!ENTITY b '&a;&#38;a;'>", "<a b='&b;'>&a;&b;&lt;</a>"),
              "<a b='xx'>xxx&lt;</a>");
    // The first definition counts; comments and CDATA are left as they are.
    EXPECT_EQ(replaced("<!-- <!ENTITY a 'no'> --><!ENTITY a 'y' ><!ENTITY a 'n'><?p ]> ?>"
                       "<!ELEMENT a ANY><!NOTATION n SYSTEM \"]>\">",
                       "<a>&a;<!-- &q; --><![CDATA[&q;]]><?q &q;?> & &; &#65;</a>"),
              "<a>y<!-- &q; --><![CDATA[&q;]]><?q &q;?> & &; &#65;</a>");
    // In an attribute a quote of an entity does not end the value; elsewhere a tag is one.
    EXPECT_EQ(replaced("<!ENTITY q \"'&#34;&#60;\"><!ENTITY t '<b c=\"&q;\"/>'>",
                       "<a b='&q;' c=\"&q;\">&t;</a>"),
              "<a b='&apos;&quot;&lt;' c=\"&apos;&quot;&lt;\"><b c=\"&apos;&quot;&lt;\"/></a>");
    EXPECT_EQ(replaced("<!ENTITY e '&#xe9;&#8364;&#x1F600;'>", "<a>&e;</a>"),
              "<a>\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80</a>");
}

TEST(Entities, HideAndMoveTheShapesOfADrawing) {
    const std::string subset =
        "<!ENTITY ns \"http://www.w3.org/2000/svg\">\n<!ENTITY st0 \"fill:black\">"
        "<!ENTITY st1 \"display:none\"><!ENTITY path \"" +
        kPath + "\">";
    EXPECT_EQ(rings_in(with_dtd(subset, "<g style='&st0;'>" + kPath + "</g>")), 1U);
    EXPECT_EQ(rings_in(with_dtd(subset, "<g style='&st1;'>" + kPath + "</g>" + kPath)), 1U);
    EXPECT_EQ(rings_in(with_dtd(
                  subset, "<style>.a {&st1;}</style>" + kPath + "<g class='a'>" + kPath + "</g>")),
              1U);
    EXPECT_EQ(rings_in(with_dtd(subset, "&path;<g xmlns='&ns;'>&path;</g>")), 1U);  // joined
}

TEST(Entities, ThatAreNotDefinedHereAreRefused) {
    const auto refused = [](const std::string& subset, const std::string& inner) {
        return tests::refusal_of([&] { rings_in(with_dtd(subset, inner + kPath)); });
    };
    const std::string bomb =
        "<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;'>"
        "<!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;'><!ENTITY d '&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;'>"
        "<!ENTITY e '&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;'><!ENTITY f '&e;&e;&e;&e;&e;&e;&e;&e;&e;&e;'>"
        "<!ENTITY g '&f;&f;&f;&f;&f;&f;&f;&f;&f;&f;'><!ENTITY h '&g;&g;&g;&g;&g;&g;&g;&g;&g;&g;'>";
    for (const auto& [subset, inner, told] : std::vector<std::array<std::string, 3>>{
             {"", "<text>&nbsp;</text>", "\"&nbsp;\": is not defined in this file"},
             {"<!ENTITY a SYSTEM 'b.svg'>", "&a;", "\"&a;\": is defined by another file"},
             {"<!ENTITY a '&b;'><!ENTITY b '&a;'>", "<g style='&a;'/>", "within each other"},
             {"<!ENTITY % a 'b'>%a;", "", "\"%a;\": is not read in a DTD"},
             {"<!ATTLIST rect display CDATA 'none'>", "", "that a DTD gives are not read"},
             {bomb, "&h;", "longer by more than 16 MiB"}}) {
        const std::string message = refused(subset, inner);
        EXPECT_TRUE(message.starts_with("file: ")) << message;
        EXPECT_NE(message.find(told), std::string::npos) << message;
    }
    EXPECT_EQ(refused("<!ENTITY a SYSTEM 'b.svg'><!ENTITY % c 'd'>"
                      "<!ATTLIST svg a:b CDATA #IMPLIED>",
                      "<text>&amp;&lt;&#65; a &b c; ?a=1&b=2</text>"),
              "accepted");
    std::string wide;
    for (const char c : with_dtd("<!ENTITY a 'b'>", "")) wide += {c, '\0'};
    EXPECT_NE(tests::refusal_of([&] { rings_in("\xff\xfe" + wide); }).find("in UTF-8 only"),
              std::string::npos);
}

// An element is a shape if its name is of SVG's namespace, by whatever prefix.
TEST(Namespaces, DecideWhichElementsAreShapes) {
    const auto count = [](const std::string& attributes, const std::string& inner) {
        return rings_in("<svg viewBox='0 0 80 80'" + attributes +
                        " xmlns:f='http://example.org/foo'"
                        " xmlns:s='http://www.w3.org/2000/svg'>"
                        "<path d='M9 9h1v2z'/>" +
                        inner + "</svg>");
    };
    for (const auto& [inner, rings] : std::vector<std::pair<std::string, std::size_t>>{
             {kPath, 2},
             {"<f:path d='M0 0h1v2z'/>", 1},
             {"<f:g>" + kPath + "</f:g>", 1},
             {"<s:g>" + kPath + "<s:path d='M20 0h1v2z'/></s:g>", 3},
             {"<g xmlns='http://example.org/foo'>" + kPath + "</g>", 1},
             {"<g xmlns='http://example.org/foo'><s:path d='M0 0h1v2z'/></g>", 1},
             {"<g xmlns:s='http://example.org/foo'><s:path d='M0 0h1v2z'/></g>", 1},
             {"<path xmlns='' d='M0 0h1v2z'/>", 1},
             {"<path f:transform='scale(0)' f:display='none' d='M0 0h1v2z'/>", 2},
             {"<f:style>path {display: none}</f:style>" + kPath, 2},
             {"<defs><path id='p' d='M0 0h1v2z'/></defs><use f:href='#q' href='#p'/>", 2},
             {"<defs><path id='p' d='M0 0h1v2z'/></defs>"
              "<use l:href='#p' xmlns:l='http://www.w3.org/1999/xlink'/>",
              2}})
        EXPECT_EQ(count(kSpace, inner), rings) << inner;
    // A drawing that says nothing of namespaces is one of SVG.
    EXPECT_EQ(count("", kPath), 2U);
    EXPECT_EQ(count("", "<g xmlns='http://example.org/foo'>" + kPath + "</g>"), 1U);
    EXPECT_EQ(tests::refusal_of([&] { count(kSpace, "<q:path id='a'/>"); }),
              "file: <q:path id=\"a\">: no xmlns:\"q\" says what namespace it is of");
    EXPECT_EQ(tests::refusal_of([&] { count(" xmlns='http://example.org/foo'", ""); }),
              "file: the outermost element is <\"svg\"> of another namespace: must be <svg>");
}

std::string packed(const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
    std::string all(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(all.data());
    stream.avail_out = static_cast<uInt>(all.size());
    deflate(&stream, Z_FINISH);
    all.resize(stream.total_out);
    deflateEnd(&stream);
    return all;
}

TEST(APackedSvg, IsReadWhateverItsNameSays) {
    const std::string plain = with_dtd("", kPath), small = packed(plain);
    for (const char* format : {"svg", "svgz"})
        EXPECT_EQ(decode_polygons(small, format, "file").rings,
                  decode_polygons(plain, "svg", "file").rings);
    for (const std::size_t length : {std::size_t{3}, small.size() / 2, small.size() - 9})
        EXPECT_EQ(tests::refusal_of([&] { rings_in(small.substr(0, length)); }),
                  "file: cannot be unpacked by gzip; is the file whole?");
}

TEST(APackedFile, MayNotHoldMoreThanAllowed) {
    const std::string large(10'000'000, ' ');
    EXPECT_EQ(files::unpacked_gzip(packed(large), "file", large.size()), large);
    EXPECT_EQ(tests::refusal_of([&] { files::unpacked_gzip(packed(large), "file", 3U << 20U); }),
              "file: holds more than 3 MiB when unpacked: must hold less");
}

}  // namespace xml_test
