#pragma once

#include "core/signing/signed_datagram.h"
#include "player/send/datagram_stream.h"

namespace rocinante {

/// Another stream with every datagram signed when it is taken, which is when it is sent.
class SigningStream final : public DatagramStream {
 public:
  /// Both must outlive this. The stream's datagrams must be packet text.
  SigningStream(DatagramStream& stream, DatagramSigner& signer)
      : stream_(stream), signer_(signer) {}

  Result<std::optional<Due>> due() override { return stream_.due(); }
  ByteView take() override { return signer_.sign(stream_.take()); }

 private:
  DatagramStream& stream_;
  DatagramSigner& signer_;
};

}  // namespace rocinante
