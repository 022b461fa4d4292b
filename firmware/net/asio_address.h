// From the address of a socket to a ClientAddress; only for the files of this room that see Asio.
#pragma once

#include <boost/asio/ip/address.hpp>

#include "net/network.h"

namespace tripoint {

ClientAddress client_address_of(const boost::asio::ip::address& address);

}  // namespace tripoint
