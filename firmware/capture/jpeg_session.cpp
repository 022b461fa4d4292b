#include "capture/jpeg_session.h"

#include <jerror.h>

#include <algorithm>

namespace tripoint {
namespace {

// The standard progressive script has 10 scans; a file of a few kilobytes can ask for thousands.
constexpr int kMaxScans = 20;

constexpr std::size_t kMaxRowsOfCall = MAX_SAMP_FACTOR * DCTSIZE;

// Real webcams pad before restart markers: up to 17 bytes in a frame whose picture is whole. A lost USB packet leaves
// a wrong marker or too little data instead, and those warnings are never borne.
constexpr int kMaxPadding_bytes = 32;

/// Oddities that leave the picture itself whole; some webcams show one of them in every frame.
bool harmless(const jpeg_error_mgr& errors) {
  switch (errors.msg_code) {
    case JWRN_EXTRANEOUS_DATA:
      return errors.msg_parm.i[0] <= kMaxPadding_bytes;
    case JWRN_NOT_SEQUENTIAL:  // parameters of a scan that a baseline decoder does not use
    case JWRN_JFIF_MAJOR:
    case JWRN_ADOBE_XFORM:
      return true;
    default:
      return false;
  }
}

/// Plain data only: libjpeg may jump out of it. Of components that are not needed it decodes the entropy alone;
/// at the start of decompression all are, so that each gets its tables.
void decode_rows(jpeg_decompress_struct& codec, const std::array<JpegTarget, 3>& targets,
                 std::span<const bool> chosen) {
  std::array<std::array<JSAMPROW, kMaxRowsOfCall>, 3> rows{};
  std::array<JSAMPARRAY, 3> components{rows[0].data(), rows[1].data(), rows[2].data()};
  const auto lines_of_call = static_cast<JDIMENSION>(codec.max_v_samp_factor * DCTSIZE);
  for (std::size_t call = 0; codec.output_scanline < codec.output_height; ++call) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(codec.num_components); ++c) {
      codec.comp_info[c].component_needed = chosen[call] ? TRUE : FALSE;
      const auto rows_of_call = static_cast<std::size_t>(codec.comp_info[c].v_samp_factor) * DCTSIZE;
      for (std::size_t r = 0; r < rows_of_call; ++r) {
        rows[c][r] = targets[c].data + (call * rows_of_call + r) * targets[c].stride_bytes;
      }
    }
    jpeg_read_raw_data(&codec, components.data(), lines_of_call);
  }
}

}  // namespace

JpegSession::JpegSession(std::span<const std::uint8_t> jpeg) : jpeg_(jpeg) {
  codec_.err = jpeg_std_error(&errors_);
  codec_.client_data = this;
  errors_.error_exit = [](j_common_ptr codec) { leave(codec); };
  errors_.emit_message = [](j_common_ptr codec, int level) { take_message(codec, level); };
  progress_.progress_monitor = [](j_common_ptr codec) { check_scans(codec); };
}

JpegSession::~JpegSession() { jpeg_destroy_decompress(&codec_); }

// libjpeg cannot be left in any other way than by a jump; nothing with a destructor lives between here and there.
// NOLINTBEGIN(cert-err52-cpp)
void JpegSession::leave(j_common_ptr codec) {
  auto* self = static_cast<JpegSession*>(codec->client_data);
  codec->err->format_message(codec, self->message_.data());
  std::longjmp(self->escape_, 1);
}

void JpegSession::take_message(j_common_ptr codec, int level) {
  if (level < 0 && !harmless(*codec->err)) leave(codec);
}

void JpegSession::check_scans(j_common_ptr codec) {
  auto* self = static_cast<JpegSession*>(codec->client_data);
  if (self->codec_.input_scan_number <= kMaxScans) return;
  std::snprintf(self->message_.data(), self->message_.size(), "more than %d scans", kMaxScans);
  std::longjmp(self->escape_, 1);
}

void JpegSession::prepare() {
  jpeg_create_decompress(&codec_);  // clears all but err and client_data
  codec_.progress = &progress_;
  jpeg_mem_src(&codec_, jpeg_.data(), jpeg_.size());
}

bool JpegSession::read_header() {
  if (setjmp(escape_) != 0) return false;
  prepare();
  jpeg_read_header(&codec_, TRUE);
  return true;
}

bool JpegSession::read_planes(const std::array<JpegTarget, 3>& targets, std::span<const bool> chosen) {
  if (setjmp(escape_) != 0) return false;
  const std::size_t before_scans = jpeg_.size() - codec_.src->bytes_in_buffer;
  codec_.raw_data_out = TRUE;
  codec_.out_color_space = codec_.jpeg_color_space;
  codec_.do_block_smoothing = FALSE;
  codec_.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&codec_);
  decode_rows(codec_, targets, chosen);
  jpeg_finish_decompress(&codec_);  // reads on to the end marker: its absence is a warning, hence an error
  scans_ = jpeg_.subspan(before_scans, jpeg_.size() - codec_.src->bytes_in_buffer - before_scans);
  return true;
}
// NOLINTEND(cert-err52-cpp)

}  // namespace tripoint
