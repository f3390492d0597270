void Gone();
void Gone() {}
