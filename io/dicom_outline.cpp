// This file follows DICOM PS3.5 section 7 (data element structure) and PS3.10 section 7 (file meta
// information).

#include "io/dicom_outline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string_view>

#include "io/volume_bytes.h"
#include "support/error.h"

namespace voroprobe
{

namespace
{

constexpr std::size_t kMarkOffset = 128;
constexpr std::string_view kMark = "DICM";
constexpr std::uint32_t kUndefinedLength = 0xffffffffU;
constexpr int kMaxDepth = 32; //!< of sequences within sequences

constexpr std::uint32_t kTransferSyntax = 0x00020010;
constexpr std::uint32_t kSeriesInstanceUid = 0x0020000e;
constexpr std::uint32_t kPixelData = 0x7fe00010;
constexpr std::uint32_t kItem = 0xfffee000;
constexpr std::uint32_t kItemEnd = 0xfffee00d;
constexpr std::uint32_t kSequenceEnd = 0xfffee0dd;

//! Value representations (PS3.5 section 6.2); in explicit encodings the long ones have a length of 32 bits.
constexpr std::array<std::string_view, 34> kTypes{
    "AE", "AS", "AT", "CS", "DA", "DS", "DT", "FD", "FL", "IS", "LO", "LT", "OB", "OD", "OF", "OL", "OV",
    "OW", "PN", "SH", "SL", "SQ", "SS", "ST", "SV", "TM", "UC", "UI", "UL", "UN", "UR", "US", "UT", "UV"};
constexpr std::array<std::string_view, 13> kLongTypes{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                      "SV", "UC", "UN", "UR", "UT", "UV"};

bool is_one_of(std::string_view type, std::span<const std::string_view> types)
{
    return std::find(types.begin(), types.end(), type) != types.end();
}

struct Encoding
{
    bool explicit_type = true;
    bool big_endian = false;
};

struct Element
{
    std::uint32_t tag;
    std::uint32_t length;
    bool is_known = true; //!< false where the value is of a type that DICOM does not have
    Encoding of_items{};  //!< where its length is undefined
};

//! Reads elements one after the other and never beyond the end of the file.
class Walker
{
public:
    explicit Walker(std::string_view bytes) : bytes_(bytes), at_(kMarkOffset + kMark.size()) {}

    [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

    //! The tag that comes next, without moving on.
    [[nodiscard]] std::uint32_t peek_tag(const Encoding& encoding) const
    {
        return (number<std::uint16_t>(at_, encoding) << 16U) | number<std::uint16_t>(at_ + 2, encoding);
    }

    //! Reads tag and length and stands at the value.
    Element next(const Encoding& encoding)
    {
        Element element{.tag = peek_tag(encoding), .length = 0, .of_items = encoding};
        at_ += 4;
        const bool is_delimiter = (element.tag >> 16U) == 0xfffeU;
        if (!encoding.explicit_type || is_delimiter)
            return with_long_length(element, encoding);
        require(2);
        const std::string_view type = bytes_.substr(at_, 2);
        at_ += 2;
        element.is_known = is_one_of(type, kTypes);
        if (type == "UN")
            element.of_items = {.explicit_type = false}; // PS3.5 section 6.2.2, note 2
        if (is_one_of(type, kLongTypes))
        {
            at_ += 2;
            return with_long_length(element, encoding);
        }
        element.length = number<std::uint16_t>(at_, encoding);
        at_ += 2;
        return element;
    }

    //! Passes over a value. \return it.
    std::string_view take(std::size_t length)
    {
        require(length);
        const std::string_view value = bytes_.substr(at_, length);
        at_ += length;
        return value;
    }

    //! Passes over items up to the end of a sequence of undefined length, or of encapsulated pixel data.
    void skip_sequence(const Encoding& encoding, int depth)
    {
        while (true)
        {
            const Element item = next(encoding);
            if (item.tag == kSequenceEnd)
                return;
            if (item.tag != kItem || depth > kMaxDepth)
                throw InputError("is damaged: no item at byte " + std::to_string(at_) + " of the DICOM file");
            if (item.length == kUndefinedLength)
                skip_item(encoding, depth);
            else
                take(item.length);
        }
    }

private:
    void skip_item(const Encoding& encoding, int depth)
    {
        while (true)
        {
            const Element element = next(encoding);
            if (element.tag == kItemEnd)
                return;
            if (element.length == kUndefinedLength)
                skip_sequence(element.of_items, depth + 1);
            else
                take(element.length);
        }
    }

    Element with_long_length(Element element, const Encoding& encoding)
    {
        element.length = number<std::uint32_t>(at_, encoding);
        at_ += 4;
        return element;
    }

    template <class Number>
    [[nodiscard]] std::uint32_t number(std::size_t at, const Encoding& encoding) const
    {
        require(at - at_ + sizeof(Number));
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < sizeof(Number); ++i)
        {
            const std::size_t place = encoding.big_endian ? i : sizeof(Number) - 1 - i;
            value = (value << 8U) | static_cast<unsigned char>(bytes_[at + place]);
        }
        return value;
    }

    //! \throw InputError where fewer bytes are left.
    void require(std::size_t count) const
    {
        if (at_ > bytes_.size() || bytes_.size() - at_ < count)
            throw InputError("is truncated: it ends at byte " + std::to_string(bytes_.size()) +
                             " within a data element, expected " + std::to_string(count) +
                             " bytes from byte " + std::to_string(at_));
    }

    std::string_view bytes_;
    std::size_t at_;
};

//! Walks the meta information. \return the UID of the transfer syntax.
std::string walk_meta_information(Walker& walker)
{
    std::string transfer_syntax;
    while (!walker.at_end() && (walker.peek_tag({}) >> 16U) == 2U)
    {
        const Element element = walker.next({});
        if (!element.is_known)
            throw InputError("is damaged: a data element of its meta information has no known type");
        const std::string_view value = walker.take(element.length);
        if (element.tag == kTransferSyntax)
            transfer_syntax = value.substr(0, value.find_last_not_of(std::string_view("\0 ", 2)) + 1);
    }
    return transfer_syntax;
}

DicomOutline walk_data_set(Walker& walker, const Encoding& encoding)
{
    DicomOutline outline;
    while (!walker.at_end())
    {
        const Element element = walker.next(encoding);
        if (!element.is_known)
            return outline;
        if (element.length == kUndefinedLength)
            walker.skip_sequence(element.of_items, 0);
        else if (const std::string_view value = walker.take(element.length);
                 element.tag == kSeriesInstanceUid)
            outline.series_uid = value.substr(0, value.find_last_not_of(std::string_view("\0 ", 2)) + 1);
        if (element.tag == kPixelData)
            return outline;
    }
    outline.has_pixels = false;
    return outline;
}

} // namespace

bool has_dicom_mark(const std::filesystem::path& path)
{
    std::error_code error;
    if (!(std::filesystem::file_size(path, error) >= kMarkOffset + kMark.size()) || error)
        return false;
    std::array<std::byte, kMark.size()> mark{};
    read_bytes({.files = {path}, .offset = kMarkOffset}, mark);
    return std::memcmp(mark.data(), kMark.data(), kMark.size()) == 0;
}

DicomOutline read_dicom_outline(const std::filesystem::path& path)
{
    if (!has_dicom_mark(path))
        throw InputError("is not a DICOM file: expected the mark \"DICM\" at byte 128");
    std::string bytes(std::filesystem::file_size(path), '\0');
    read_bytes({.files = {path}}, std::as_writable_bytes(std::span(bytes)));

    Walker walker(bytes);
    const std::string transfer_syntax = walk_meta_information(walker);
    if (transfer_syntax == "1.2.840.10008.1.2.1.99")
        return {}; // deflated: the data set has no structure to see
    return walk_data_set(walker, {.explicit_type = transfer_syntax != "1.2.840.10008.1.2",
                                  .big_endian = transfer_syntax == "1.2.840.10008.1.2.2"});
}

} // namespace voroprobe
