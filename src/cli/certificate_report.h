#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "certificate/certificate.h"
#include "geometry/affine_transform.h"

namespace voroprobe
{

//! Lines for a report: surfaces expected, meshed, missing (the first few by name), handles, distances. Boxes
//! are given in the frame of `shown_from_oracle`, mm.
std::string certificate_lines(const Certificate& certificate, const AffineTransform& shown_from_oracle);

//! The object `certificate` of summaries (README.md, "Checking meshes"). Boxes as above; infinite distances
//! are null.
nlohmann::ordered_json certificate_json(const Certificate& certificate,
                                        const AffineTransform& shown_from_oracle);

} // namespace voroprobe
