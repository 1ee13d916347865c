// Sides of one patch on the other one, as contacts. Internal to solver/; docs/method-doubles.md,
// section 14.7.
#pragma once

#include "filter/contact.h"

namespace exsect::filter {

/// Adds the side of one patch that lies on the other one in part; nothing if it is known already, or of
/// patches that are not biquadratic if it is inside of the other one.
template <class K>
void add_path(const SidePath& path, const PairOf<K>& pair, ContactsOf<K>& contacts);
/// Adds the line along which the patches touch; false if it is known already, or a side of both.
template <class K>
bool add_contact_line(const ContactLineOf<K>& line, ContactsOf<K>& contacts);

}  // namespace exsect::filter
