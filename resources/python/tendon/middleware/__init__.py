"""Communication between programs: frames on a link, the handshake, requests and their replies."""
