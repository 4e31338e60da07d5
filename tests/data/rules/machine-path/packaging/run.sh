cd /home/somebody/kickstand
cd "$HOME/kickstand" && cd ~/home/x
curl https://example.org/home/page
