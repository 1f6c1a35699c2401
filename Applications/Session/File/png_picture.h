// A picture as the bytes of a PNG file, made on as many threads as there are.
#ifndef oversketch_applications_session_file_png_picture_h
#define oversketch_applications_session_file_png_picture_h

#include <cstdint>
#include <string>
#include <vector>

namespace oversketch_session
{

// Writes samples of 8 bits, rows from the bottom: 1 or 3 a pixel. Why not libpng: it compresses on one
// thread, which takes longer for a large photograph than all else that is done with it. Strips of rows are
// compressed by themselves here, the same whatever the threads, by runs alone after a filter, and joined as
// RFC 1950 and 1951 allow. Throws std::runtime_error where zlib fails.
std::string pngOf(const std::vector<std::uint8_t>& samples, int width, int height, int colours);

} // namespace oversketch_session
#endif
