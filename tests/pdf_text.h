// What a PDF file tells about itself, for tests that look for words in it.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstddef>
#include <string>

namespace lacuna::tests {

// The file, followed by the objects that are compressed in it: from version 1.18 on, cairo
// compresses the pages' sizes and the file's origin, too.
inline std::string pdf_text(const std::string& pdf) {
    const std::string objects_of_a_stream = "/Type /ObjStm";
    const std::string begin = "stream\n";
    std::string text = pdf;
    for (std::size_t at = pdf.find(objects_of_a_stream); at != std::string::npos;
         at = pdf.find(objects_of_a_stream, at + 1)) {
        const std::size_t first = pdf.find(begin, at) + begin.size();
        // zlib finds the end by itself.
        std::string objects(std::size_t{1} << 16, '\0');
        uLongf length = objects.size();
        EXPECT_EQ(
            uncompress(reinterpret_cast<Bytef*>(objects.data()), &length,
                       reinterpret_cast<const Bytef*>(pdf.data() + first), pdf.size() - first),
            Z_OK);
        text.append(objects, 0, length);
    }
    return text;
}

}  // namespace lacuna::tests
