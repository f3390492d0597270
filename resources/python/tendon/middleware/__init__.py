"""Programs talking: frames on a link, the handshake, requests and their answers."""
